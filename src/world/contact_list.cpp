#include "contact_list.hpp"

#include <algorithm>

namespace scree {

bool ContactList::renew(std::span<const PartPair> pairs, const Maker& make) {
    if (std::equal(pairs.begin(), pairs.end(), pairs_.begin(), pairs_.end())) {
        return false;
    }
    next_.clear();
    std::size_t old = 0;
    for (const PartPair& pair : pairs) {
        while (old < pairs_.size() && pairs_[old] < pair) {
            ++old;
        }
        const bool known = old < pairs_.size() && pairs_[old] == pair;
        next_.push_back(known ? contacts_[old] : make(pair));
    }
    contacts_.swap(next_);
    next_.clear();  // what the old ones hold is let go
    pairs_.assign(pairs.begin(), pairs.end());
    return true;
}

void ContactList::remake(const Maker& make) {
    contacts_.clear();
    for (const PartPair& pair : pairs_) {
        contacts_.push_back(make(pair));
    }
}

void ContactList::clear() {
    contacts_.clear();
    pairs_.clear();
}

void ContactList::renumber(std::span<const int> new_numbers) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        PartPair pair = pairs_[i];
        pair.body_a = new_numbers[static_cast<std::size_t>(pair.body_a)];
        pair.body_b = new_numbers[static_cast<std::size_t>(pair.body_b)];
        if (pair.body_a < 0 || pair.body_b < 0) {
            continue;
        }
        Contact& contact = contacts_[kept] = contacts_[i];
        contact.a.body = pair.body_a;
        contact.b.body = pair.body_b;
        pairs_[kept++] = pair;
    }
    pairs_.resize(kept);
    contacts_.resize(kept);
}

}  // namespace scree
