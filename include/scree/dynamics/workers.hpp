#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace scree {

/// A fixed number of threads that share out numbered jobs. Which thread takes which job is left to chance, so
/// jobs must not depend on one another; what they write is then the same for any number of threads.
class Workers {
  public:
    /// The calling thread is one of the `threads` ≥ 1.
    explicit Workers(std::size_t threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// How many, the calling one among them.
    [[nodiscard]] std::size_t threads() const { return crew_.size() + 1; }

    /// Calls job(0) … job(count − 1) and returns when all are done; an exception of the lowest job that threw
    /// one is thrown again. Not to be called from within a job.
    void run(std::size_t count, const std::function<void(std::size_t)>& job);

  private:
    void live();
    void take_jobs(std::unique_lock<std::mutex>& lock);

    std::vector<std::thread> crew_;
    std::mutex mutex_;
    std::condition_variable begun_, ended_;
    const std::function<void(std::size_t)>* job_ = nullptr;
    std::size_t count_ = 0;    ///< jobs of this run
    std::size_t next_ = 0;     ///< the first that nobody has taken
    std::size_t running_ = 0;  ///< taken and not done
    std::size_t failed_ = 0;   ///< the lowest that threw
    std::exception_ptr error_;
    bool over_ = false;
};

}  // namespace scree
