#pragma once

#include <memory>
#include <vector>

#include <scree/bdf/integrator.hpp>

namespace scree {

/// Where a body must stay for the present contacts to be complete.
struct BodyCover {
    Pose about;         ///< of the body when it was laid
    double radius = 0;  ///< [m], of a ball about the body's origin that holds it
    double reach = 0;   ///< [m], how far any point of that ball may move
};

struct MergedMemory;

/// Bodies that may touch one another before the next meeting, with steps of their own. They live in a system
/// of their own, which is filled from the whole at every meeting and handed back to it at the next.
class Group {
  public:
    /// `bodies`: numbers in the whole, ascending; the dynamic ones, and the others that they may touch.
    Group(std::vector<int> bodies, const ContactForces& forces, const SteppingOptions& options,
          Workers* workers);

    /// Their numbers in the whole, ascending.
    [[nodiscard]] const std::vector<int>& bodies() const { return bodies_; }
    /// The place of a body of the whole among them; −1: not here.
    [[nodiscard]] int place_of(int body) const;
    /// The group's own system, of which body i is bodies()[i] of the whole.
    [[nodiscard]] const System& system() const { return system_; }
    /// What steps it.
    [[nodiscard]] const Integrator& integrator() const { return *integrator_; }
    /// The same, to be changed.
    [[nodiscard]] Integrator& integrator() { return *integrator_; }

    /// What the method carried to the last meeting.
    [[nodiscard]] const SteppingMemory& start() const { return start_; }
    /// Sets that, for a group that takes over from others.
    void begin_with(MergedMemory merged);
    /// Bodies have other numbers, by the old ones. Returns false when one of the group's is no more.
    bool renumber(std::span<const int> new_numbers);
    /// At the next load the method starts afresh.
    void restart() { restart_ = true; }

    /// Fills the system from the whole as of the last meeting, at `time` [s]; `contacts` are numbers in the
    /// whole. A group that has arrived already with just these contacts keeps what it has; one that starts
    /// afresh hands to the whole what its contacts hold then.
    void load(System& whole, std::span<const std::size_t> contacts, double time);
    /// Steps to `end` [s] or until it can go no farther. `demand` [m], one a body of the whole, is raised
    /// where a body needs more reach than its cover has.
    StepOutcome advance(double end, std::span<const BodyCover> covers, std::span<double> demand);
    /// The last advance reached its end.
    [[nodiscard]] bool arrived() const { return arrived_; }
    /// The last advance could not go on.
    [[nodiscard]] bool failed() const { return failed_; }
    /// It is at rest and steps no more.
    [[nodiscard]] bool asleep() const { return asleep_; }

    /// Hands states and contact memories back: a meeting.
    void commit(System& whole, std::vector<ContactResult>& results);

    /// What it carries from one meeting to the next.
    friend void visit_state(auto& with, StateOf<Group> auto& group) {
        auto& [bodies, options, system, contacts, integrator, start, influences, covers, demand, restart,
               arrived, failed, asleep, calm, results, leaders] = group;
        with(start, asleep, calm, results);
    }
    /// As after the meeting of which the state is. Throws StateError for one of other bodies and contacts.
    void go_on(const System& whole, std::span<const std::size_t> contacts);

  private:
    [[nodiscard]] bool same_contacts(const System& whole, std::span<const std::size_t> contacts) const;
    bool load_bodies(const System& whole);
    void assume(std::size_t body);
    void load_contacts(const System& whole, std::span<const std::size_t> contacts);
    void shorten_memories();
    void hand_back(System& whole) const;
    bool covered(std::span<const TrialBody> trial);
    [[nodiscard]] static bool drives(const Body& body, const BodyState& state, double time);
    [[nodiscard]] bool at_rest() const;
    [[nodiscard]] bool may_rest() const;
    bool stopped_from_outside(System& whole, double time);

    std::vector<int> bodies_;
    SteppingOptions options_;
    System system_;
    std::vector<std::size_t> contacts_;  ///< numbers in the whole
    std::unique_ptr<Integrator> integrator_;
    SteppingMemory start_;
    struct Influence {
        Vec3 force, torque;
    };
    std::vector<Influence> influences_;  ///< what acts from outside less what did at the last load
    std::span<const BodyCover> covers_;
    std::span<double> demand_;
    bool restart_ = true;
    bool arrived_ = false;
    bool failed_ = false;
    bool asleep_ = false;
    std::size_t calm_ = 0;                ///< meetings at which it was at rest, in a row
    std::vector<ContactResult> results_;  ///< of a group asleep: what its contacts did when it fell asleep
    std::vector<int> leaders_;  ///< bodies whose contacts keep their whole past at the next load; empty: all
};

/// What a group carries that takes over from others.
struct MergedMemory {
    SteppingMemory memory;          ///< at the present time
    const Group* leader = nullptr;  ///< whose contacts alone keep their whole past; null: all do
};

/// For a group of these bodies from the groups in which they were: the past of the one with the smallest
/// step, and that of the others brought to its times. Without parents, or where one has no past up to the
/// present `time`, there is none.
MergedMemory merged_memory(std::span<const Group* const> parents, const std::vector<int>& bodies,
                           const System& whole, double time);

}  // namespace scree
