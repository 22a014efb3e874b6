#include <algorithm>
#include <limits>

#include <scree/bdf/group.hpp>

namespace scree {

namespace {

constexpr std::size_t most_merged_order = 2;
constexpr std::size_t most_merged_values = 3;

bool same_times(const StateHistory& a, const StateHistory& b) {
    return std::equal(a.times().begin(), a.times().end(), b.times().begin(), b.times().end());
}

// The values of the leader's past that every parent can give.
std::size_t common_count(std::span<const Group* const> parents, const StateHistory& past) {
    std::size_t count = std::min(past.count(), most_merged_values);
    for (const Group* parent : parents) {
        const double oldest = parent->start().past.times().back();
        while (count > 1 && past.times()[count - 1] < oldest) {
            --count;
        }
    }
    return count;
}

// The state of a body of the whole at the j-th of the leader's times.
BodyState past_state(std::span<const Group* const> parents, const Group& leader, int body, std::size_t j,
                     const BodyState& present) {
    const double time = leader.start().past.times()[j];
    if (const int place = leader.place_of(body); place >= 0) {
        return leader.start().past.states(j)[static_cast<std::size_t>(place)];
    }
    for (const Group* parent : parents) {
        const int place = parent->place_of(body);
        if (place < 0) {
            continue;
        }
        const SteppingMemory& memory = parent->start();
        const auto number = static_cast<std::size_t>(place);
        if (same_times(memory.past, leader.start().past)) {
            return memory.past.states(j)[number];
        }
        return memory.past.at(time, number, std::min(memory.order + 1, memory.past.count()));
    }
    return present;  // a body that stands, or that has come only now
}

// The parent with the smallest step; null when one of them has no past up to the present.
const Group* leader_of(std::span<const Group* const> parents, double time) {
    const Group* leader = nullptr;
    for (const Group* parent : parents) {
        const SteppingMemory& memory = parent->start();
        if (parent->asleep() || memory.past.count() == 0 || memory.time != time) {
            return nullptr;
        }
        if (leader == nullptr || memory.next_step < leader->start().next_step) {
            leader = parent;
        }
    }
    return leader;
}

}  // namespace

MergedMemory merged_memory(std::span<const Group* const> parents, const std::vector<int>& bodies,
                           const System& whole, double time) {
    const Group* leader = leader_of(parents, time);
    if (leader == nullptr) {
        return {};
    }
    const StateHistory& past = leader->start().past;
    const bool together = std::all_of(parents.begin(), parents.end(), [&](const Group* parent) {
        return same_times(parent->start().past, past);
    });
    const std::size_t count = together ? past.count() : common_count(parents, past);
    SteppingMemory memory = leader->start();
    memory.powers.reset();
    for (std::size_t j = 0; j < count; ++j) {
        std::vector<BodyState> states;
        for (const int body : bodies) {
            const BodyState& present = whole.states[static_cast<std::size_t>(body)];
            states.push_back(j == 0 ? present : past_state(parents, *leader, body, j, present));
        }
        if (j == 0) {
            memory.past.restart(time, states);
        } else {
            memory.past.append(past.times()[j], states);
        }
    }
    memory.order = std::min({memory.order, count, together ? memory.order : most_merged_order});
    for (const Group* parent : parents) {
        memory.patience = std::max(memory.patience, parent->start().patience);
        memory.barred = std::max(memory.barred, parent->start().barred);
    }
    return {std::move(memory), together ? nullptr : leader};
}

}  // namespace scree
