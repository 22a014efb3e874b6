#pragma once

#include <map>
#include <string>
#include <utility>

#include "engine.hpp"
#include "pair_solver.hpp"

namespace scree {

/// A scene in a btDiscreteDynamicsWorld with Bullet's own solver, as it comes but for the number of its
/// iterations: the same shapes, masses and prescribed bodies, friction of the pairs, restitution by their
/// damping ratio at a face of area Lc². Its steps divide the time between outputs. No body is put to sleep.
class BulletEngine final : public Engine {
  public:
    explicit BulletEngine(const SceneDescription& scene);
    ~BulletEngine() override;

    void add(SimulationBody& body, const MaterialDescription& material) override;
    bool advance(double begin, double end) override;
    void save(StateWriter& with) const override;
    void restore(StateReader& with) override;
    [[nodiscard]] const StepReport& report() const override { return report_; }
    [[nodiscard]] FrameMotion motion(std::size_t number) const override;
    [[nodiscard]] std::span<const Contact> contacts() const override { return contacts_; }
    [[nodiscard]] std::span<const ContactResult> contact_results() const override { return results_; }

  private:
    struct Member {
        btRigidBody* rigid = nullptr;
        const std::string* material = nullptr;  ///< its name, in the scene
        double radius = 0;                      ///< ℓ [m], of a dynamic body
        std::shared_ptr<const PrescribedPath> path;
        Vec3 surface_velocity = Vec3::Zero();  ///< [m/s]
        Quat orientation;                      ///< as last seen, so that its sign does not change
    };
    struct PairNumbers {
        double friction = 0;
        double restitution = 0;
    };

    static void save(const Member& member, StateWriter& with);
    static void restore(StateReader& with, Member& member);
    void restore_manifolds(StateReader& with);
    void step_to(double time);
    void adjust(btPersistentManifold& manifold);
    PairNumbers pair_numbers(const Member& a, const Member& b);
    void read_orientations();
    void read_contacts();
    void sort_contacts();
    void read_contact(const btPersistentManifold& manifold, double step);
    void read_energy();
    [[nodiscard]] bool finite() const;
    [[nodiscard]] Member& member(const btCollisionObject& object) {
        return members_[static_cast<std::size_t>(object.getUserIndex())];
    }

    const SceneDescription& scene_;
    std::vector<Member> members_;
    std::map<std::pair<const std::string*, const std::string*>, PairNumbers> pairs_;
    StepReport report_;
    std::vector<Contact> contacts_;
    std::vector<ContactResult> results_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    PairSolver solver_{[this](btPersistentManifold& manifold) { adjust(manifold); }};
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

}  // namespace scree
