#include <scree/dynamics/stored_force.hpp>

#include <scree/contact/carried_force.hpp>

namespace scree {

bool remembers(const Contact& contact, const ContactResult& result, std::size_t values) {
    return result.law.state == ContactState::stick && contact.history.age >= values &&
           values <= contact.history.past.size() && result.law.trial.stiffness > 0;
}

double stored_difference(const Contact& contact, const ContactResult& result, std::span<const double> weights,
                         std::span<const Quat> turns_a, std::span<const Quat> turns_b) {
    Vec3 sum = weights[0] * result.law.trial.force;
    for (std::size_t j = 0; j + 1 < weights.size(); ++j) {
        const FrictionRecord& record = contact.history.past[j];
        sum += weights[j + 1] * carry(record, result.normal, turns_a[j], turns_b[j], true, nullptr).force;
    }
    return sum.norm() / result.law.trial.stiffness;
}

}  // namespace scree
