#pragma once

#include <memory>
#include <vector>

#include <scree/dynamics/contact_forces.hpp>

namespace scree {

/// The forces of a world: the user's law, or as much of the built-in one as the present pairs can enter.
class LawChoice final : public ContactForces {
  public:
    /// Null: the built-in law.
    void set(std::unique_ptr<ContactForces> forces) { given_ = std::move(forces); }
    /// The built-in law, with other choices.
    void set(FrictionLaw friction, const LawOptions& options);

    /// For contacts of another number than 0, see PairConstants::law; returns the number. Null: the law of
    /// all others.
    int add(std::unique_ptr<ContactForces> forces);

    /// For the evaluations that follow.
    void choose(std::span<const Contact> contacts);

    void evaluate(std::span<const Contact> contacts, std::span<const TrialBody> bodies,
                  const StepFormulas& formulas, Detail detail,
                  std::span<ContactResult> results) const override;

  private:
    [[nodiscard]] const ContactForces& of(int law) const;
    [[nodiscard]] LawParts needed(std::span<const Contact> contacts) const;

    std::unique_ptr<ContactForces> given_;
    std::vector<std::unique_ptr<ContactForces>> added_;
    FrictionLaw friction_ = FrictionLaw::cundall_strack;
    LawOptions options_;
    LawParts parts_;  ///< of the built-in law as it is
    std::unique_ptr<ContactForces> built_in_ =
        std::make_unique<ForcesOf<BuiltInLaw<LawParts{}>>>(BuiltInLaw<LawParts{}>{});
};

}  // namespace scree
