#pragma once

#include <memory>
#include <span>
#include <vector>

#include <scree/bdf/group.hpp>

namespace scree {

/// Steps a whole system in groups of bodies that may touch one another, each with its own step and order,
/// from one meeting to the next. At a meeting all are at the same time, and the whole system holds their
/// states.
///
/// From a meeting on: deal() the bodies out by the present contacts; advance() the groups. When a body has
/// left its cover, enlarge that, renew the contacts, and deal and advance again: groups that nobody new has
/// come to keep what they have done. When all have arrived, commit().
class Groups {
  public:
    /// Of a system that must outlive them.
    explicit Groups(System& whole) : whole_(whole) {}

    /// How steps are made from the next deal on; all groups end. `forces` and `workers` must outlive their
    /// use.
    void set(const ContactForces& forces, const SteppingOptions& options, Workers* workers);

    /// Others share out the work; changes no result.
    void set_workers(Workers* workers);

    /// The body was changed from outside: its group starts afresh.
    void restart(int body) { restarts_.push_back(body); }
    /// Bodies have other numbers, by the old ones; −1: is no more, and so is its group.
    void renumber(std::span<const int> new_numbers);
    /// Nothing but the memories is carried on from before, so that a run that stops here can go on alike.
    void forget();

    /// By the whole's present contacts, at the time [s] of the last meeting.
    void deal(double time);
    /// All groups to `end` [s]. left_cover: `demand` [m], one a body, is what covers need there and 0
    /// elsewhere.
    StepOutcome advance(double end, std::span<const BodyCover> covers, std::vector<double>& demand);
    /// A meeting: the whole gets the states and contact memories; prescribed bodies move as prescribed.
    void commit(double end);

    /// What is carried from one meeting to the next.
    void save(StateWriter& with) const;
    /// As after a meeting at `time` [s], of which the whole is already. Throws StateError.
    void restore(StateReader& with, double time);

    /// What each of the whole's contacts did at the last meeting; empty after a failure.
    [[nodiscard]] std::span<const ContactResult> results() const { return results_; }
    /// A group that could not go on in the last advance; null: there is none.
    [[nodiscard]] const Group* failed() const;
    /// How many groups there are.
    [[nodiscard]] std::size_t count() const { return groups_.size(); }
    /// Whether a body's group is at rest and steps no more.
    [[nodiscard]] bool asleep(int body) const;
    /// The groups, from the last deal on.
    [[nodiscard]] std::span<const std::unique_ptr<Group>> all() const { return groups_; }

    /// What has flowed since last taken.
    Flows take_flows() { return std::exchange(flows_, {}); }
    /// Counts since last taken: of the group with the most steps between each two meetings, and of all.
    struct Counts {
        SteppingStatistics leading;  ///< of the group with the most steps
        SteppingStatistics all;      ///< of all groups together
    };
    /// Hands the counts over and starts them at zero.
    Counts take_counts() { return std::exchange(counts_, {}); }

  private:
    void abandon();
    void find_parts();
    int root(int body);
    void sort_parts(std::size_t parts);
    void collect(std::size_t part);
    [[nodiscard]] std::span<const std::size_t> contacts_of(std::size_t part) const;
    void number_bodies();
    std::unique_ptr<Group> group_for(std::size_t part, double time);
    [[nodiscard]] std::vector<const Group*> parents_of(std::span<const int> bodies) const;
    void move_prescribed(double end);
    void add_counts();

    System& whole_;
    const ContactForces* forces_ = nullptr;
    SteppingOptions options_;
    Workers* workers_ = nullptr;

    std::vector<std::unique_ptr<Group>> groups_, previous_;
    std::vector<int> group_of_;  ///< by body, −1: in none
    std::vector<int> restarts_;
    std::vector<ContactResult> results_;
    double met_ = 0;  ///< [s], of the last meeting
    Flows flows_;
    Counts counts_;

    // Buffers of the deal: parts by body and by contact, each part's members in a row.
    std::vector<int> parent_, part_of_, members_, bodies_;
    std::vector<std::size_t> part_begin_, contact_begin_, contact_members_;
};

}  // namespace scree
