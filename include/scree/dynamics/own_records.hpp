#pragma once

#include <array>
#include <cstring>
#include <span>
#include <vector>

#include <scree/contact/history.hpp>

namespace scree {

/// The records of a law with a history of its own, between its type and the plain numbers that contacts keep.
template <class History>
class OwnRecords {
  public:
    /// Takes out those of the accepted steps in contact.
    explicit OwnRecords(const ContactHistory& history) {
        if (history.own.size() != numbers * history.past.size()) {
            return;
        }
        count_ = history.age;
        for (std::size_t j = 0; j < count_; ++j) {
            std::memcpy(static_cast<void*>(&past_[j]), &history.own[numbers * j], sizeof(History));
        }
    }
    /// The records, the latest first.
    [[nodiscard]] std::span<const History> past() const { return std::span(past_).first(count_); }

    /// Puts a record into plain numbers, in place of what is there.
    void write(const History& record, std::vector<double>& to) const {
        to.assign(numbers, 0);
        std::memcpy(to.data(), &record, sizeof(History));
    }

  private:
    static constexpr std::size_t numbers = (sizeof(History) + sizeof(double) - 1) / sizeof(double);

    std::array<History, highest_order> past_{};
    std::size_t count_ = 0;
};

}  // namespace scree
