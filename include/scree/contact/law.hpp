#pragma once

#include <concepts>
#include <type_traits>

#include <scree/contact/history.hpp>
#include <scree/contact/material.hpp>
#include <scree/contact/motion.hpp>
#include <scree/overlap/depth_potential.hpp>

namespace scree {

/// Everything a contact law may look at. A law is pure: the same input gives the same output, whatever was
/// asked before; only the caller, on accepting a step, makes a trial record history.
struct ContactInput {
    const ContactGeometry& geometry;            ///< where the overlap is, at the trial poses
    const RelativeMotion& motion;               ///< of A against B there, at the trial velocities
    const PairConstants& pair;                  ///< constants of the pair
    const ContactHistory& history;              ///< of accepted steps
    const FrictionStep& step;                   ///< how the history enters the trial
    const PairArms& arms;                       ///< of the contact about both mass centres
    const MotionRates* rates = nullptr;         ///< set when derivatives are wanted
    const PatchCells* cells = nullptr;          ///< of the patch, for a law that asks for them
    const DepthPotential* potential = nullptr;  ///< likewise
};

/// What friction does: there is no force, the contact sticks, it is at its limit.
enum class ContactState { open, stick, slip };
template <>
inline constexpr std::uint64_t enumerators<ContactState> = 3;  ///< as StateReader checks it

/// Where the power of a contact goes [W].
struct ContactPower {
    double normal_elastic =
        0;  ///< into normal elasticity; 0 where ContactForce::normal_energy tells the state
    double normal_damping = 0;      ///< lost
    double normal = 0;              ///< into normal elasticity and damping together
    double tangential = 0;          ///< into the tangential spring and slip together
    double tangential_damping = 0;  ///< lost
    double torsion = 0;             ///< into the torsional spring, slip and damping together
    double rolling = 0;             ///< into the rolling spring, its limit and damping together
    double cohesion = 0;            ///< against the pull of cohesion
};

void visit_state(auto& with, StateOf<ContactPower> auto& power) {
    auto& [normal_elastic, normal_damping, normal, tangential, tangential_damping, torsion, rolling,
           cohesion] = power;
    with(normal_elastic, normal_damping, normal, tangential, tangential_damping, torsion, rolling, cohesion);
}

/// Which branches of a law its answer came from; its derivative jumps where they change.
struct ContactRegime {
    ContactState state = ContactState::open;  ///< of the friction
    bool rolls = false;                       ///< the rolling resistance is at its limit
    std::bitset<PatchCells::count> slipping;  ///< cells of the patch that are at their limit

    /// On the same branch everywhere.
    bool operator==(const ContactRegime&) const = default;
};
/// What a contact law answers.
struct ContactForce {
    Vec3 force = Vec3::Zero();   ///< [N], on A at the centroid; −force on B
    Vec3 moment = Vec3::Zero();  ///< [N m], on A about the centroid; −moment on B
    double normal_force = 0;     ///< fn [N], along the normal; below 0 where cohesion pulls
    FrictionRecord trial;        ///< what the history becomes if the step is accepted
    /// What becomes history of the patch's cells; empty or one.
    std::vector<PatchRecord> cells;
    ContactState state = ContactState::open;  ///< slip: all cells of a patch are at their limit
    bool rolls = false;                       ///< the rolling resistance is at its limit
    ContactPower power;                       ///< at the trial velocities
    double normal_energy = 0;                 ///< stored [J], where the law has a potential
    double tangential_energy = 0;             ///< stored [J]
    double torsional_energy = 0;              ///< stored [J]
    double rolling_energy = 0;                ///< stored [J]
    double cohesive_energy = 0;               ///< [J], below 0: what it takes to pull the bodies apart
    bool lost_direction = false;        ///< a stored force was normal to the new plane and started from zero
    Mat39 force_rate = Mat39::Zero();   ///< by the nine unknowns of MotionRates, when asked for
    Mat39 moment_rate = Mat39::Zero();  ///< likewise

    /// The branches that this answer came from.
    [[nodiscard]] ContactRegime regime() const {
        return {state, rolls, cells.empty() ? std::bitset<PatchCells::count>() : cells.front().slipping};
    }
    /// As made, but for memory that is kept for the next use.
    void reset() {
        cells.clear();
        std::vector<PatchRecord> kept = std::move(cells);
        *this = ContactForce{};
        cells = std::move(kept);
    }
};
void visit_state(auto& with, StateOf<ContactForce> auto& answer) {
    auto& [force, moment, normal_force, trial, cells, state, rolls, power, normal_energy, tangential_energy,
           torsional_energy, rolling_energy, cohesive_energy, lost_direction, force_rate, moment_rate] =
        answer;
    with(force, moment, normal_force, trial, cells, state, rolls, power, normal_energy, tangential_energy,
         torsional_energy, rolling_energy, cohesive_energy, lost_direction);
}

/// A law that remembers nothing but friction: `law(input, force)` fills `force`.
template <class Law>
concept PlainLaw = requires(const Law& law, const ContactInput& input, ContactForce& force) {
    law(input, force);
};

/// A law with a history of its own, plain data of a type Law::History. It gets its records of the accepted
/// steps in contact, the latest first and none at first touch, and fills what becomes the next one if the
/// step is accepted.
template <class Law>
concept LawWithHistory = std::is_trivially_copyable_v<typename Law::History> &&
    std::default_initializable<typename Law::History> &&
    requires(const Law& law, const ContactInput& input, std::span<const typename Law::History> past,
             ContactForce& force, typename Law::History& trial) {
    law(input, past, force, trial);
};

/// A law answers for one contact at a time, and may be asked from several threads at once. It sets the force
/// and moment on A, normal_force, and a state other than open where there is a force; trial.force as well
/// when it has a stored friction that it wants to find in the history.
///
/// A law that says `static constexpr bool gives_rates = true` also sets force_rate and moment_rate when
/// input.rates is set; Newton's method differences all others. One that says `gives_power` sets power; for
/// all others everything that goes in normally or tangentially counts as lost.
template <class Law>
concept ContactLaw = PlainLaw<Law> || LawWithHistory<Law>;

/// A law that sets force_rate and moment_rate.
template <class Law>
concept GivesRates = requires {
    requires Law::gives_rates;
};
/// A law that sets power.
template <class Law>
concept GivesPower = requires {
    requires Law::gives_power;
};

}  // namespace scree
