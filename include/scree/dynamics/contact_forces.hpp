#pragma once

#include <span>
#include <vector>

#include <scree/contact/built_in_law.hpp>
#include <scree/dynamics/contact.hpp>
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
    OverlapWorkspace overlap;
    ContactGeometry geometry;
    MotionRates rates;
    PatchCells cells;
    DepthPotential potential;
};
/// That of the calling thread.
ContactWorkspace& contact_workspace();

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

template <ContactLaw Law>
class ForcesOf final : public ContactForces {
  public:
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
        const FrictionStep step{formulas.friction(contact.history.age), a.turns, b.turns,
                                formulas.friction_cap};
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
        law_({geometry, motion, contact.pair, contact.history, step, arms, rates, cells, potential},
             result.law);
        settle(geometry, motion, a, arms, rates, result);
    }

    Law law_;
};

}  // namespace scree
