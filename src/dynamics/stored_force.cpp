#include <scree/dynamics/stored_force.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <scree/contact/carried_force.hpp>

namespace scree {

bool remembers(const Contact& contact, const ContactResult& result, std::size_t values) {
    const std::size_t age = result.law.cells.empty() ? contact.history.age : contact.history.patch_age;
    return result.law.state == ContactState::stick && age >= values &&
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

// The root of the mean square over the cells of a patch, those at their limit counting as without error.
double patch_difference(const Contact& contact, const ContactResult& result, std::span<const double> weights,
                        std::span<const Quat> turns_a, std::span<const Quat> turns_b) {
    const PatchRecord& now = result.law.cells.front();
    std::array<Vec3, PatchCells::count> sums;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] = weights[0] * now.force[i];
    }
    for (std::size_t j = 0; j + 1 < weights.size(); ++j) {
        const PatchRecord& past = contact.history.patch[j];
        const FrictionRecord axis{.force = past.axis, .normal = contact.history.past[j].normal};
        const Vec3 carried = carry(axis, result.normal, turns_a[j], turns_b[j], true, nullptr).force;
        const double cosine = now.axis.dot(carried);
        const double sine = result.normal.dot(now.axis.cross(carried));
        Mat3 turn;
        turn << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += weights[j + 1] * (turn * past.force[i]);
        }
    }
    double square = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        square += now.slipping[i] ? 0 : sums[i].squaredNorm();
    }
    return std::sqrt(square / static_cast<double>(sums.size()));
}

}  // namespace

double stored_difference(const Contact& contact, const ContactResult& result, std::span<const double> weights,
                         std::span<const Quat> turns_a, std::span<const Quat> turns_b) {
    double size = result.law.cells.empty()
                      ? difference(contact, result, weights, turns_a, turns_b, &FrictionRecord::force).norm()
                      : patch_difference(contact, result, weights, turns_a, turns_b);
    if (contact.pair.rolling_friction > 0 && !result.law.rolls) {
        const Vec3 rolling = difference(contact, result, weights, turns_a, turns_b, &FrictionRecord::rolling);
        size = std::max(size, rolling.norm());
    }
    return size / result.law.trial.stiffness;
}

}  // namespace scree
