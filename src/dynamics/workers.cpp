#include <scree/dynamics/workers.hpp>

#include <exception>
#include <utility>

namespace scree {

Workers::Workers(std::size_t threads) {
    for (std::size_t i = 1; i < threads; ++i) {
        crew_.emplace_back([this] { live(); });
    }
}

Workers::~Workers() {
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    begun_.notify_all();
    for (std::thread& thread : crew_) {
        thread.join();
    }
}

void Workers::run(std::size_t count, const std::function<void(std::size_t)>& job) {
    if (crew_.empty() || count < 2) {
        for (std::size_t i = 0; i < count; ++i) {
            job(i);
        }
        return;
    }
    std::unique_lock lock(mutex_);
    job_ = &job;
    count_ = count;
    next_ = 0;
    error_ = nullptr;
    begun_.notify_all();
    take_jobs(lock);
    ended_.wait(lock, [this] { return running_ == 0; });
    job_ = nullptr;
    if (error_) {
        std::rethrow_exception(std::exchange(error_, nullptr));
    }
}

void Workers::live() {
    std::unique_lock lock(mutex_);
    while (true) {
        begun_.wait(lock, [this] { return over_ || (job_ != nullptr && next_ < count_); });
        if (over_) {
            return;
        }
        take_jobs(lock);
        ended_.notify_one();
    }
}

void Workers::take_jobs(std::unique_lock<std::mutex>& lock) {
    while (next_ < count_) {
        const std::size_t mine = next_++;
        ++running_;
        lock.unlock();
        std::exception_ptr error;
        try {
            (*job_)(mine);
        } catch (...) {
            error = std::current_exception();
        }
        lock.lock();
        --running_;
        if (error && (!error_ || mine < failed_)) {
            error_ = error;
            failed_ = mine;
        }
    }
}

}  // namespace scree
