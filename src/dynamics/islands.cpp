#include <scree/dynamics/islands.hpp>

#include <numeric>

namespace scree {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

int Islands::root(int body) {
    while (parent_[at(body)] != body) {
        parent_[at(body)] = parent_[at(parent_[at(body)])];
        body = parent_[at(body)];
    }
    return body;
}

void Islands::find(std::span<const Body> bodies, std::span<const Contact> contacts,
                   std::span<const ContactResult> results) {
    parent_.resize(bodies.size());
    std::iota(parent_.begin(), parent_.end(), 0);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const int a = contacts[i].a.body;
        const int b = contacts[i].b.body;
        if (results[i].law.state == ContactState::open || !bodies[at(a)].dynamic() ||
            !bodies[at(b)].dynamic()) {
            continue;
        }
        const int root_a = root(a);
        const int root_b = root(b);
        parent_[at(std::max(root_a, root_b))] = std::min(root_a, root_b);
    }

    // A root is its island's lowest body, so islands and members come in ascending order.
    island_.assign(bodies.size(), -1);
    place_.assign(bodies.size(), -1);
    std::vector<int>& size = members_;  // first how many, then who
    size.assign(bodies.size(), 0);
    begin_.assign(1, 0);
    int found = 0;
    for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
        if (!bodies[at(b)].dynamic()) {
            continue;
        }
        const int lowest = root(b);
        if (lowest == b) {
            island_[at(b)] = found++;
        }
        island_[at(b)] = island_[at(lowest)];
        place_[at(b)] = size[at(island_[at(b)])]++;
    }
    for (int i = 0; i < found; ++i) {
        begin_.push_back(begin_.back() + at(size[at(i)]));
    }
    members_.resize(begin_.back());
    for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
        if (island_[at(b)] >= 0) {
            members_[begin_[at(island_[at(b)])] + at(place_[at(b)])] = b;
        }
    }
}

std::span<const int> Islands::bodies(std::size_t island) const {
    return std::span(members_).subspan(begin_[island], begin_[island + 1] - begin_[island]);
}

}  // namespace scree
