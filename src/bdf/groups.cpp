#include <scree/bdf/groups.hpp>

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

// A group's own contacts are shared out from so many on, or from fewer where there is little else to do.
constexpr std::size_t large = 256;
constexpr std::size_t large_alone = 64;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

void Groups::set(const ContactForces& forces, const SteppingOptions& options, Workers* workers) {
    forces_ = &forces;
    options_ = options;
    workers_ = workers;
    groups_.clear();
    group_of_.clear();
}

void Groups::set_workers(Workers* workers) {
    workers_ = workers;
    for (const auto& group : groups_) {
        group->integrator().set_workers(workers);
    }
}

void Groups::renumber(std::span<const int> new_numbers) {
    std::erase_if(groups_, [&](const auto& group) { return !group->renumber(new_numbers); });
    number_bodies();
}

void Groups::number_bodies() {
    group_of_.assign(whole_.bodies.size(), -1);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        for (const int body : groups_[g]->bodies()) {
            if (whole_.bodies[at(body)].dynamic()) {
                group_of_[at(body)] = static_cast<int>(g);
            }
        }
    }
}

void Groups::forget() {
    for (const auto& group : groups_) {
        group->integrator().contacts_renewed();
    }
}

void Groups::deal(double time) {
    met_ = time;
    abandon();
    group_of_.resize(whole_.bodies.size(), -1);
    find_parts();
    groups_.swap(previous_);
    groups_.clear();
    for (std::size_t part = 0; part + 1 < part_begin_.size(); ++part) {
        collect(part);
        groups_.push_back(group_for(part, time));
    }
    previous_.clear();
    number_bodies();
    for (const int body : restarts_) {
        for (const auto& group : groups_) {
            if (group->place_of(body) >= 0) {
                group->restart();
            }
        }
    }
    restarts_.clear();
    for (std::size_t part = 0; part < groups_.size(); ++part) {
        groups_[part]->load(whole_, contacts_of(part), time);
    }
}

std::span<const std::size_t> Groups::contacts_of(std::size_t part) const {
    const std::size_t begin = contact_begin_[part];
    return std::span(contact_members_).subspan(begin, contact_begin_[part + 1] - begin);
}

void Groups::save(StateWriter& with) const {
    with(groups_.size());
    for (const auto& group : groups_) {
        with(*group);
    }
}

// The groups are those that the whole's contacts make, as at the last deal.
void Groups::restore(StateReader& with, double time) {
    met_ = time;
    restarts_.clear();
    groups_.clear();
    find_parts();
    std::size_t count = 0;
    with(count);
    StateReader::require(count + 1 == part_begin_.size());
    for (std::size_t part = 0; part < count; ++part) {
        collect(part);
        groups_.push_back(std::make_unique<Group>(bodies_, *forces_, options_, workers_));
        with(*groups_.back());
        groups_.back()->go_on(whole_, contacts_of(part));
    }
    number_bodies();
}

// Steps of groups that could not reach the meeting count for nothing but what they cost.
void Groups::abandon() {
    for (const auto& group : groups_) {
        if (group->arrived()) {
            continue;
        }
        group->integrator().take_flows();
        const SteppingStatistics costs = group->integrator().take_statistics().without_steps();
        counts_.all.add(costs);
        counts_.leading.rejected_contact += costs.rejected_contact;
    }
}

int Groups::root(int body) {
    while (parent_[at(body)] != body) {
        parent_[at(body)] = parent_[at(parent_[at(body)])];
        body = parent_[at(body)];
    }
    return body;
}

// Dynamic bodies that contacts join are a part; an explicit method has one step for all, so that they are
// one.
void Groups::find_parts() {
    const std::size_t count = whole_.bodies.size();
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0);
    const auto join = [&](int a, int b) {
        const int root_a = root(a);
        const int root_b = root(b);
        parent_[at(std::max(root_a, root_b))] = std::min(root_a, root_b);
    };
    for (const Contact& contact : whole_.contacts) {
        if (whole_.bodies[at(contact.a.body)].dynamic() && whole_.bodies[at(contact.b.body)].dynamic()) {
            join(contact.a.body, contact.b.body);
        }
    }
    int first = -1;
    part_of_.assign(count, -1);
    std::size_t parts = 0;
    for (std::size_t b = 0; b < count; ++b) {
        if (!whole_.bodies[b].dynamic()) {
            continue;
        }
        if (options_.fixed_step > 0) {
            first = first < 0 ? static_cast<int>(b) : first;
            join(first, static_cast<int>(b));
        }
        const int lowest = root(static_cast<int>(b));  // bodies join lower ones only: met before
        part_of_[b] = at(lowest) == b ? static_cast<int>(parts++) : part_of_[at(lowest)];
    }
    sort_parts(parts);
}

// By counting: where each part's bodies and contacts begin, then who they are, in ascending order.
void Groups::sort_parts(std::size_t parts) {
    part_begin_.assign(parts + 1, 0);
    contact_begin_.assign(parts + 1, 0);
    const auto part_of_contact = [&](const Contact& contact) {
        const int part = part_of_[at(contact.a.body)];
        return at(part >= 0 ? part : part_of_[at(contact.b.body)]);
    };
    std::size_t dynamic = 0;
    for (const int part : part_of_) {
        if (part >= 0) {
            ++part_begin_[at(part) + 1];
            ++dynamic;
        }
    }
    for (const Contact& contact : whole_.contacts) {
        ++contact_begin_[part_of_contact(contact) + 1];
    }
    std::partial_sum(part_begin_.begin(), part_begin_.end(), part_begin_.begin());
    std::partial_sum(contact_begin_.begin(), contact_begin_.end(), contact_begin_.begin());
    members_.resize(dynamic);
    contact_members_.resize(whole_.contacts.size());
    for (std::size_t b = 0; b < part_of_.size(); ++b) {
        if (part_of_[b] >= 0) {
            members_[part_begin_[at(part_of_[b])]++] = static_cast<int>(b);
        }
    }
    for (std::size_t i = 0; i < whole_.contacts.size(); ++i) {
        contact_members_[contact_begin_[part_of_contact(whole_.contacts[i])]++] = i;
    }
    std::rotate(part_begin_.begin(), part_begin_.end() - 1, part_begin_.end());
    std::rotate(contact_begin_.begin(), contact_begin_.end() - 1, contact_begin_.end());
    part_begin_.front() = contact_begin_.front() = 0;
}

// Into bodies_: the part's dynamic bodies and the others that they may touch.
void Groups::collect(std::size_t part) {
    bodies_.assign(members_.begin() + static_cast<std::ptrdiff_t>(part_begin_[part]),
                   members_.begin() + static_cast<std::ptrdiff_t>(part_begin_[part + 1]));
    for (std::size_t i = contact_begin_[part]; i < contact_begin_[part + 1]; ++i) {
        const Contact& contact = whole_.contacts[contact_members_[i]];
        for (const int body : {contact.a.body, contact.b.body}) {
            if (!whole_.bodies[at(body)].dynamic()) {
                bodies_.push_back(body);
            }
        }
    }
    std::sort(bodies_.begin(), bodies_.end());
    bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
}

// The group that these bodies were before, or a new one that takes over from those in which they were.
std::unique_ptr<Group> Groups::group_for(std::size_t part, double time) {
    const int before = group_of_[at(members_[part_begin_[part]])];
    if (before >= 0 && previous_[at(before)] && previous_[at(before)]->bodies() == bodies_) {
        return std::move(previous_[at(before)]);
    }
    auto group = std::make_unique<Group>(bodies_, *forces_, options_, workers_);
    group->begin_with(merged_memory(parents_of(bodies_), bodies_, whole_, time));
    return group;
}

std::vector<const Group*> Groups::parents_of(std::span<const int> bodies) const {
    std::vector<const Group*> parents;
    for (const int body : bodies) {
        if (!whole_.bodies[at(body)].dynamic()) {
            continue;
        }
        const int number = group_of_[at(body)];
        if (number < 0) {
            return {};  // a body without a past
        }
        const Group* parent = previous_[at(number)].get();
        if (std::find(parents.begin(), parents.end(), parent) == parents.end()) {
            parents.push_back(parent);
        }
    }
    return parents;
}

// Large groups one after another, the workers sharing out their contacts; small ones side by side.
StepOutcome Groups::advance(double end, std::span<const BodyCover> covers, std::vector<double>& demand) {
    demand.assign(whole_.bodies.size(), 0);
    std::vector<StepOutcome> outcomes(groups_.size());
    std::vector<std::size_t> small;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const std::size_t contacts = groups_[g]->system().contacts.size();
        const bool most = contacts >= large_alone && 2 * contacts >= whole_.contacts.size();
        const bool shares = contacts >= large || most;
        groups_[g]->integrator().set_workers(shares ? workers_ : nullptr);
        if (shares) {
            outcomes[g] = groups_[g]->advance(end, covers, demand);
        } else {
            small.push_back(g);
        }
    }
    const auto job = [&](std::size_t i) {
        outcomes[small[i]] = groups_[small[i]]->advance(end, covers, demand);
    };
    if (workers_ != nullptr) {
        workers_->run(small.size(), job);
    } else {
        for (std::size_t i = 0; i < small.size(); ++i) {
            job(i);
        }
    }
    StepOutcome worst = StepOutcome::accepted;
    for (const StepOutcome outcome : outcomes) {
        worst = std::max(worst, outcome == StepOutcome::failed ? StepOutcome::left_cover : outcome);
    }
    if (failed() != nullptr) {
        results_.clear();  // they belong to no present contacts
        return StepOutcome::failed;
    }
    return worst;
}

void Groups::commit(double end) {
    results_.resize(whole_.contacts.size());
    for (const auto& group : groups_) {
        group->commit(whole_, results_);
        const Flows flows = group->integrator().take_flows();
        flows_.energy.add(1, flows.energy);
        flows_.momentum_gain += flows.momentum_gain;
    }
    add_counts();
    move_prescribed(end);
    met_ = end;
}

void Groups::add_counts() {
    const SteppingStatistics* leading = nullptr;
    std::vector<SteppingStatistics> each;
    each.reserve(groups_.size());
    for (const auto& group : groups_) {
        each.push_back(group->integrator().take_statistics());
        counts_.all.add(each.back());
        if (leading == nullptr || each.back().accepted > leading->accepted) {
            leading = &each.back();
        }
    }
    if (leading != nullptr) {
        counts_.leading.add(*leading);
    }
}

// They belong to no group alone, so all take them from here.
void Groups::move_prescribed(double end) {
    for (std::size_t b = 0; b < whole_.bodies.size(); ++b) {
        BodyState& state = whole_.states[b];
        if (const PrescribedPath* path = whole_.bodies[b].path) {
            const PathPoint point = path->at(end);
            state = {point.pose.position, point.pose.orientation, point.velocity, point.spin};
        } else if (!whole_.bodies[b].dynamic()) {
            advance_prescribed(end - met_, state);
        }
    }
}

bool Groups::asleep(int body) const {
    const auto number = at(body);
    return number < group_of_.size() && group_of_[number] >= 0 && groups_[at(group_of_[number])]->asleep();
}

const Group* Groups::failed() const {
    const auto found =
        std::find_if(groups_.begin(), groups_.end(), [](const auto& group) { return group->failed(); });
    return found == groups_.end() ? nullptr : found->get();
}

}  // namespace scree
