// What there is to know of Bullet's own world after a tick.

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include <scree/detect/convert.hpp>

#include "bullet_engine.hpp"

namespace scree {

namespace {

// The solver stops points before they touch.
bool touches(const btManifoldPoint& point) {
    return point.getDistance() <= 0 || point.m_appliedImpulse > 0;
}

bool touches(const btPersistentManifold& manifold) {
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        if (touches(manifold.getContactPoint(i))) {
            return true;
        }
    }
    return false;
}

/// On the first body of the manifold [N s].
Vec3 impulse(const btManifoldPoint& point) {
    return to_eigen(point.m_appliedImpulse * point.m_normalWorldOnB +
                    point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                    point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2);
}

Vec3 velocity_at(const btCollisionObject& object, const btVector3& point) {
    const btRigidBody& rigid = *btRigidBody::upcast(&object);
    return to_eigen(rigid.getVelocityInLocalPoint(point - rigid.getCenterOfMassPosition()));
}

/// Joins the points of a manifold to one contact, each with the weight of its impulse. A is the manifold's
/// first body.
ContactResult joined(const btPersistentManifold& manifold, double step) {
    ContactResult result;
    result.touching = true;
    result.law.state = ContactState::stick;
    Vec3 points = Vec3::Zero();
    Vec3 normals = Vec3::Zero();
    double weights = 0;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        if (!touches(point)) {
            continue;
        }
        const double weight = std::max(point.m_appliedImpulse, std::numeric_limits<double>::min());
        weights += weight;
        points += weight * to_eigen(point.getPositionWorldOnB());
        normals += weight * to_eigen(point.m_normalWorldOnB);
        result.depth = std::max(result.depth, -point.getDistance());
        result.law.force += impulse(point) / step;
        result.law.normal_force += point.m_appliedImpulse / step;
    }
    result.point = points / weights;
    result.normal = normals.normalized();
    return result;
}

double kinetic_energy(const btRigidBody& rigid) {
    const Vec3 spin =
        to_eigen(rigid.getWorldTransform()).orientation.conjugate() * to_eigen(rigid.getAngularVelocity());
    const Vec3 moments = to_eigen(rigid.getInvInertiaDiagLocal()).cwiseInverse();
    return 0.5 / rigid.getInvMass() * rigid.getLinearVelocity().length2() +
           0.5 * spin.dot(moments.cwiseProduct(spin));
}

}  // namespace

void BulletEngine::read_energy() {
    report_.energy = {};
    for (const Member& member : members_) {
        if (member.rigid->getInvMass() > 0) {
            report_.energy.kinetic += kinetic_energy(*member.rigid);
            report_.energy.gravity -= scene_.gravity.dot(to_eigen(member.rigid->getCenterOfMassPosition())) /
                                      member.rigid->getInvMass();
        }
    }
}

void BulletEngine::read_contacts() {
    contacts_.clear();
    results_.clear();
    const double step = report_.steps.time_stepped / static_cast<double>(report_.steps.accepted);
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
        if (touches(manifold)) {
            read_contact(manifold, step);
        }
    }
    sort_contacts();
    report_.contacts = contacts_.size();
    report_.most_contacts = std::max(report_.most_contacts, report_.contacts);
}

// By bodies; a pair has one manifold.
void BulletEngine::sort_contacts() {
    std::vector<std::size_t> order(contacts_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return std::tie(contacts_[i].a.body, contacts_[i].b.body) <
               std::tie(contacts_[j].a.body, contacts_[j].b.body);
    });
    const std::vector<Contact> contacts = contacts_;
    const std::vector<ContactResult> results = results_;
    for (std::size_t i = 0; i < order.size(); ++i) {
        contacts_[i] = contacts[order[i]];
        results_[i] = results[order[i]];
    }
}

void BulletEngine::read_contact(const btPersistentManifold& manifold, double step) {
    const Member& first = member(*manifold.getBody0());
    const Member& second = member(*manifold.getBody1());
    ContactResult result = joined(manifold, step);
    const btVector3 point = to_bullet(result.point);
    const Vec3 slip = velocity_at(*first.rigid, point) - velocity_at(*second.rigid, point) +
                      first.surface_velocity - second.surface_velocity;
    result.slip_speed = (slip - slip.dot(result.normal) * result.normal).norm();
    for (const Member* own : {&first, &second}) {
        if (own->radius > 0) {
            report_.largest_overlap = std::max(report_.largest_overlap, result.depth / own->radius);
        }
    }
    Contact contact;
    contact.a.body = first.rigid->getUserIndex();
    contact.b.body = second.rigid->getUserIndex();
    if (contact.a.body > contact.b.body) {
        std::swap(contact.a, contact.b);
        result.normal = -result.normal;
        result.law.force = -result.law.force;
    }
    contacts_.push_back(contact);
    results_.push_back(result);
}

}  // namespace scree
