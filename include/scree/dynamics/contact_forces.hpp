#pragma once

#include <span>
#include <vector>

#include <scree/contact/built_in_law.hpp>
#include <scree/dynamics/contact.hpp>
#include <scree/dynamics/law_differences.hpp>
#include <scree/dynamics/own_records.hpp>
#include <scree/dynamics/pair_motion.hpp>
#include <scree/overlap/overlap.hpp>

namespace scree {

/// Evaluates a batch of contacts at trial states. One virtual call a batch; within it the law is known by
/// type. May be called from several threads at once.
class ContactForces {
  public:
    virtual ~ContactForces() = default;

    /// Fills results[i] from contacts[i]; bodies are looked up by number. Changes nothing else.
    virtual void evaluate(std::span<const Contact> contacts, std::span<const TrialBody> bodies,
                          const StepFormulas& formulas, Detail detail,
                          std::span<ContactResult> results) const = 0;
};

/// Buffers of one contact's evaluation, one a thread; nothing in them outlives it.
struct ContactWorkspace {
    OverlapWorkspace overlap;  ///< of the shapes
    ContactGeometry geometry;  ///< of the contact at hand
    MotionRates rates;         ///< of the motion there
    PatchCells cells;          ///< of the patch, for laws that want them
    DepthPotential potential;  ///< of the overlap, likewise
    ContactForce law;          ///< of a law that is differenced
    std::vector<double> own;   ///< the same
};
/// That of the calling thread.
ContactWorkspace& contact_workspace();
/// Another one, for differences about what is in the first.
ContactWorkspace& second_contact_workspace();

/// Where the overlap is, and how the bodies move there. Returns false when they do not overlap.
bool locate(const Contact& contact, const TrialBody& a, const TrialBody& b, Detail detail,
            OverlapWorkspace& workspace, ContactGeometry& geometry, PairArms& arms);

/// The cells of the patch that was located last; null where it has none.
const PatchCells* locate_cells(const Contact& contact, const TrialBody& a, const FrictionStep& step,
                               bool co_rotation, ContactWorkspace& workspace);

/// The potential of the overlap that was located last; null for one that is not of two polyhedra.
const DepthPotential* locate_potential(const Contact& contact, const TrialBody& a, Detail detail,
                                       ContactWorkspace& workspace);

/// Copies what reports and the assembly need out of a contact's evaluation.
void settle(const ContactGeometry& geometry, const RelativeMotion& motion, const TrialBody& a,
            const PairArms& arms, const MotionRates* rates, ContactResult& result);

/// Sets the power of a law that keeps no account of it: what does not show in a stored energy is lost.
void account_as_lost(const ContactGeometry& geometry, const RelativeMotion& motion, ContactForce& law);

/// The forces of a law that is known by type.
template <ContactLaw Law>
class ForcesOf final : public ContactForces {
  public:
    /// Of a copy of `law`.
    explicit ForcesOf(Law law) : law_(std::move(law)) {}

    void evaluate(std::span<const Contact> contacts, std::span<const TrialBody> bodies,
                  const StepFormulas& formulas, Detail detail,
                  std::span<ContactResult> results) const override {
        ContactWorkspace& workspace = contact_workspace();
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Contact& contact = contacts[i];
            evaluate_one(contact, bodies[static_cast<std::size_t>(contact.a.body)],
                         bodies[static_cast<std::size_t>(contact.b.body)], formulas, detail, workspace,
                         results[i]);
        }
    }

  private:
    void evaluate_one(const Contact& contact, const TrialBody& a, const TrialBody& b,
                      const StepFormulas& formulas, Detail detail, ContactWorkspace& workspace,
                      ContactResult& result) const {
        ContactGeometry& geometry = workspace.geometry;
        PairArms arms;
        result.touching = locate(contact, a, b, detail, workspace.overlap, geometry, arms);
        result.law.state = ContactState::open;
        if (!result.touching) {
            return;
        }
        RelativeMotion motion = relative_motion(a, b, arms);
        MotionRates* rates = nullptr;
        if (detail == Detail::derivative) {
            motion_rates(geometry, motion, a, b, arms, formulas.beta_h, workspace.rates);
            rates = &workspace.rates;
        }
        if (const Vec3 surface = a.surface_velocity - b.surface_velocity; surface != Vec3::Zero()) {
            add_surface_motion(surface, geometry.normal, motion, rates);
        }
        const FrictionStep step = friction_step(contact, a, b, formulas);
        const PatchCells* cells = nullptr;
        if constexpr (requires { law_.wants_cells(contact.pair); }) {
            if (law_.wants_cells(contact.pair)) {
                cells = locate_cells(contact, a, step, law_.options.co_rotation, workspace);
            }
        }
        const DepthPotential* potential = nullptr;
        if constexpr (requires { law_.wants_potential(); }) {
            if (law_.wants_potential()) {
                potential = locate_potential(contact, a, detail, workspace);
            }
        }
        ask({geometry, motion, contact.pair, contact.history, step, arms, GivesRates<Law> ? rates : nullptr,
             cells, potential},
            result.law, result.own);
        if constexpr (!GivesPower<Law>) {
            account_as_lost(geometry, motion, result.law);
        }
        if constexpr (!GivesRates<Law>) {
            if (rates != nullptr) {
                difference(contact, a, b, formulas, geometry.depth, result.law);
            }
        }
        settle(geometry, motion, a, arms, rates, result);
    }

    static FrictionStep friction_step(const Contact& contact, const TrialBody& a, const TrialBody& b,
                                      const StepFormulas& formulas) {
        return {formulas.friction(contact.history.age), a.turns, b.turns, formulas.friction_cap};
    }

    /// A law of one's own finds `out` empty.
    void ask(const ContactInput& in, ContactForce& out, std::vector<double>& own) const {
        if constexpr (!GivesPower<Law>) {
            out.reset();
        }
        if constexpr (LawWithHistory<Law>) {
            const OwnRecords<typename Law::History> records(in.history);
            typename Law::History trial{};
            law_(in, records.past(), out, trial);
            records.write(trial, own);
        } else {
            law_(in, out);
        }
    }

    /// The rates of a law that gives none, by differences of the nine unknowns one by one.
    void difference(const Contact& contact, const TrialBody& a, const TrialBody& b,
                    const StepFormulas& formulas, double depth, ContactForce& law) const {
        ContactWorkspace& workspace = second_contact_workspace();
        const DifferenceSteps steps(contact.pair, depth, formulas.beta_h);
        for (int unknown = 0; unknown < 9; ++unknown) {
            law.force_rate.col(unknown).setZero();
            law.moment_rate.col(unknown).setZero();
            for (const double step : {steps.of(unknown), -steps.of(unknown)}) {
                const NudgedPair to(a, b, unknown, step, formulas.beta_h);
                PairArms arms;
                if (!locate(contact, to.a, to.b, Detail::force, workspace.overlap, workspace.geometry,
                            arms)) {
                    continue;  // then the other way
                }
                RelativeMotion motion = relative_motion(to.a, to.b, arms);
                add_surface_motion(a.surface_velocity - b.surface_velocity, workspace.geometry.normal, motion,
                                   nullptr);
                ContactForce& there = workspace.law;
                ask({workspace.geometry, motion, contact.pair, contact.history,
                     friction_step(contact, to.a, to.b, formulas), arms},
                    there, workspace.own);
                law.force_rate.col(unknown) = (there.force - law.force) / step;
                law.moment_rate.col(unknown) = (there.moment - law.moment) / step;
                break;
            }
        }
    }

    Law law_;
};

}  // namespace scree
