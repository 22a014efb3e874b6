#include <scree/dynamics/stored_force.hpp>

#include <algorithm>

#include <scree/contact/carried_force.hpp>

namespace scree {

bool remembers(const Contact& contact, const ContactResult& result, std::size_t values) {
    return result.law.state == ContactState::stick && contact.history.age >= values &&
           values <= contact.history.past.size() && result.law.trial.stiffness > 0;
}

namespace {

Vec3 difference(const Contact& contact, const ContactResult& result, std::span<const double> weights,
                std::span<const Quat> turns_a, std::span<const Quat> turns_b, Vec3 FrictionRecord::*which) {
    Vec3 sum = weights[0] * result.law.trial.*which;
    for (std::size_t j = 0; j + 1 < weights.size(); ++j) {
        const FrictionRecord& past = contact.history.past[j];
        const FrictionRecord record{.force = past.*which, .normal = past.normal};
        sum += weights[j + 1] * carry(record, result.normal, turns_a[j], turns_b[j], true, nullptr).force;
    }
    return sum;
}

}  // namespace

double stored_difference(const Contact& contact, const ContactResult& result, std::span<const double> weights,
                         std::span<const Quat> turns_a, std::span<const Quat> turns_b) {
    double size = difference(contact, result, weights, turns_a, turns_b, &FrictionRecord::force).norm();
    if (contact.pair.rolling_friction > 0 && !result.law.rolls) {
        const Vec3 rolling = difference(contact, result, weights, turns_a, turns_b, &FrictionRecord::rolling);
        size = std::max(size, rolling.norm());
    }
    return size / result.law.trial.stiffness;
}

}  // namespace scree
