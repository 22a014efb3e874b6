// What a tick costs before anything happens: an empty world, and worlds whose bodies fly apart or rest. The
// median over repetitions of the processor time per tick, beside Bullet's own world.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include <tests/world/bullet_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr int repetitions = 9;

template <class World>
double microseconds(SceneOf<World>& scene, int ticks) {
    std::vector<double> times;
    for (int r = 0; r < repetitions; ++r) {
        const std::clock_t start = std::clock();
        for (int i = 0; i < ticks; ++i) {
            scene.world->stepSimulation(1.0 / 60, 1, 1.0 / 60);
        }
        times.push_back(1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / ticks);
    }
    std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
    return times[repetitions / 2];
}

void let_sleep(DynamicsWorld& world) {
    SteppingOptions options;
    options.sleep = true;
    world.set_stepping(options);
}
void let_sleep(btDiscreteDynamicsWorld& /*its bodies do so anyway*/) {}

template <class World>
double empty() {
    SceneOf<World> scene;
    return microseconds(scene, 100000);
}

template <class World>
double flying(int count) {
    SceneOf<World> scene;
    auto& shape = scene.template shape<btSphereShape>(0.1);
    for (int i = 0; i < count; ++i) {
        scene.add(1, shape, Vec3(i % 10, i / 10 % 10, i / 100)).setActivationState(DISABLE_DEACTIVATION);
    }
    return microseconds(scene, 200000 / (count * 10 + 100));
}

template <class World>
double sleeping(int count) {
    SceneOf<World> scene;
    let_sleep(*scene.world);
    scene.add(0, scene.template shape<btBoxShape>(btVector3(100, 100, 1)), Vec3(0, 0, -1));
    auto& shape = scene.template shape<btBoxShape>(btVector3(0.1, 0.1, 0.1));
    for (int i = 0; i < count; ++i) {
        scene.add(1, shape, Vec3(i % 10, i / 10 % 10, 0.1));
    }
    for (int i = 0; i < 180; ++i) {
        scene.world->stepSimulation(1.0 / 60, 1, 1.0 / 60);
    }
    return microseconds(scene, 2000);
}

}  // namespace

int main() {
    std::printf("%-36s %10s %10s\n", "[us a tick]", "scree", "Bullet");
    std::printf("%-36s %10.3g %10.3g\n", "nothing", empty<DynamicsWorld>(), empty<btDiscreteDynamicsWorld>());
    std::printf("%-36s %10.3g %10.3g\n", "1 ball that flies", flying<DynamicsWorld>(1),
                flying<btDiscreteDynamicsWorld>(1));
    std::printf("%-36s %10.3g %10.3g\n", "500 balls that fly", flying<DynamicsWorld>(500),
                flying<btDiscreteDynamicsWorld>(500));
    std::printf("%-36s %10.3g %10.3g\n", "100 boxes asleep on a plate", sleeping<DynamicsWorld>(100),
                sleeping<btDiscreteDynamicsWorld>(100));
}
