#pragma once

#include <functional>
#include <span>
#include <vector>

#include <scree/detect/pair_search.hpp>
#include <scree/dynamics/contact.hpp>

namespace scree {

/// Keeps a system's contacts in step with the pairs that the search finds, both sorted alike. A pair is known
/// by its bodies and parts; one that was there before keeps its constants and what it remembers.
class ContactList {
  public:
    explicit ContactList(std::vector<Contact>& contacts) : contacts_(contacts) {}

    using Maker = std::function<Contact(const PartPair&)>;
    /// Returns whether the list has changed.
    bool renew(std::span<const PartPair> pairs, const Maker& make);

    void clear();

    /// new_numbers: by a body's old number, ascending where they are kept; −1: its contacts end.
    void renumber(std::span<const int> new_numbers);

    /// The pairs; what the contacts remember is the system's.
    friend void visit_state(auto& with, StateOf<ContactList> auto& list) {
        auto& [contacts, pairs, next] = list;
        with(pairs);
    }
    [[nodiscard]] std::span<const PartPair> pairs() const { return pairs_; }
    /// Makes the contacts of the pairs anew.
    void remake(const Maker& make);

  private:
    std::vector<Contact>& contacts_;
    std::vector<PartPair> pairs_;  ///< of the contacts
    std::vector<Contact> next_;
};

}  // namespace scree
