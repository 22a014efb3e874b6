#pragma once

#include <memory>

#include <scree/dynamics/contact_forces.hpp>

namespace scree {

/// The forces of a world: the user's law, or as much of the built-in one as the present pairs can enter.
class LawChoice final : public ContactForces {
  public:
    /// Null: the built-in law.
    void set(std::unique_ptr<ContactForces> forces) { given_ = std::move(forces); }

    /// For the evaluations that follow.
    void choose(std::span<const Contact> contacts);

    void evaluate(std::span<const Contact> contacts, std::span<const TrialBody> bodies,
                  const StepFormulas& formulas, Detail detail,
                  std::span<ContactResult> results) const override {
        current_->evaluate(contacts, bodies, formulas, detail, results);
    }

  private:
    template <LawParts parts>
    using BuiltIn = ForcesOf<CundallStrack<parts>>;

    std::unique_ptr<ContactForces> given_;
    BuiltIn<LawParts{.friction = true, .torsion = true}> whole_{{}};
    BuiltIn<LawParts{.friction = true, .torsion = false}> without_torsion_{{}};
    BuiltIn<LawParts{.friction = false, .torsion = false}> frictionless_{{}};
    ContactForces* current_ = &whole_;
};

}  // namespace scree
