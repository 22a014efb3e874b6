#include <tests/support/bad_scenes.hpp>

#include <span>

#include <tests/scenes/small_scene.hpp>

namespace scree::test {

namespace {

struct BadText {
    const char* text;
    const char* message;
};

constexpr BadText bad_text_table[] = {
    {"", "small.json:1: found end of input, expected"},
    {"{", "small.json:1: found end of input, expected"},
    {"{\n\"end_time\": 1,\n}", "small.json:3: found '}', expected string literal"},
    {"{\n\n\"end_time\": tru}", "small.json:3: found invalid literal"},
    {"{\"end_time\": 1} {", "small.json:1: found '{', expected end of input"},
    {"{\"end_time\": 1e999}", "small.json:1: found a number that is too large, expected a double"},
    {"{\"end_time\": NaN}", "small.json:1: found invalid literal"},
    {"{\"a\nb\": 1}", "small.json:1: found invalid string"},
    {"{\"\xff\": 1}", "small.json:1: found invalid string"},
    {"{} // comment \n /* without end", "small.json:2: found invalid comment"},
    {"[]", "small.json: found [], expected an object"},
    {"3", "small.json: found 3, expected an object"},
    {"{}", "small.json: found no \"materials\", expected that key"},
    {"{\"end_time\": 1, \"end_time\": 1}", "small.json: end_time: found the key twice"},
    {"{\"law\": {\"normal\": 1, \"normal\": 1}}", "small.json: law.normal: found the key twice"},
    {"{\"bodies\": [{}, {\"name\": 1, \"name\": 1}]}", "small.json: bodies.1.name: found the key twice"},
    {"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[", "found a value nested 17 deep, expected 16 at most"},
    {"{\"end_time\": 01}", "small.json:1: found"},
    {"{\"end_time\": +1}", "small.json:1: found"},
    {"{\"end_time\": .5}", "small.json:1: found"},
    {"{\"end_time\": 0x10}", "small.json:1: found"},
    {"{\"end_time\": Infinity}", "small.json:1: found"},
    {"{'end_time': 1}", "small.json:1: found"},
    {"{\"end_time\" = 1}", "small.json:1: found"},
    {"{\"end_time\": 1 \"output\": {}}", "small.json:1: found"},
    {"{\n\n\n\"end_time\": [1, 2}", "small.json:4: found"},
    {"{\"end_time\": \"1}", "small.json:1: found"},
    {"# a comment\n{}", "small.json:1: found"},
    {"null", "small.json: found null, expected an object"},
    {"\"scene\"", "small.json: found \"scene\", expected an object"},
    {"{\"a\": \"\\ud800\"}", "small.json:1: found"},
    {"{\"fill\": [{\"box\": [[1, 1, 1], [2, 2, 2]], \"box\": 1}]}",
     "small.json: fill.0.box: found the key twice"},
    {"{\"materials\": {\"rock\": {}, \"rock\": {}}}", "small.json: materials.rock: found the key twice"},
};

struct BadSetting {
    const char* setting;
    const char* message;
};

constexpr BadSetting bad_settings[] = {
    // Unknown keys name the nearest known one.
    {"gravitty=[0,0,0]", "gravitty: found an unknown key, expected \"gravity\""},
    {"law.frictoin=none", "law.frictoin: found an unknown key, expected \"friction\""},
    {"stepping.stp=1", "stepping.stp: found an unknown key, expected \"step\""},
    {"output.evry=1", "output.evry: found an unknown key, expected \"every\""},
    {"materials.rock.youngs_moduls=1",
     "materials.rock.youngs_moduls: found an unknown key, expected "
     "\"youngs_modulus\""},
    {"bodies.1.pos=1", "bodies.1.pos: found an unknown key, expected \"position\""},
    {"shapes.ball.radius=1", "shapes.ball.radius: found an unknown key"},
    {"shapes.ball.scale=2", "shapes.ball.scale: found an unknown key"},
    {"shapes.floor.half_space.ofset=1",
     "shapes.floor.half_space.ofset: found an unknown key, expected "
     "\"offset\""},
    // Wrong kinds.
    {"gravity=9.81", "gravity: found 9.81, expected a list of 3 numbers"},
    {"gravity=[0,0]", "gravity: found [0,0], expected a list of 3 numbers"},
    {"gravity=[0,0,down]", "gravity: found \"[0,0,down]\", expected a list of 3 numbers"},
    {"gravity=[0,0,\"down\"]", "gravity.2: found \"down\", expected a number"},
    {"gravity=null", "gravity: found null, expected"},
    {"materials=[]", "materials: found [], expected an object"},
    {"materials.rock=3", "materials.rock: found 3, expected an object"},
    {"materials.rock.friction=rough", "materials.rock.friction: found \"rough\", expected a number"},
    {"materials.rock.torsion=1", "materials.rock.torsion: found 1, expected true, false or \"patch\""},
    {"bodies={}", "bodies: found an object, expected a list"},
    {"bodies.1.name=7", "bodies.1.name: found 7, expected a name"},
    {"bodies.1.motion=stuck", "bodies.1.motion: found \"stuck\", expected \"dynamic\", \"fixed\" or"},
    {"law.co_rotation=1", "law.co_rotation: found 1, expected true or false"},
    {"law.normal=hertz", "law.normal: found \"hertz\", expected one of \"volume\""},
    {"stepping.step=fast", "stepping.step: found \"fast\", expected \"adaptive\" or a number above 0"},
    {"stepping.max_order=1.5", "stepping.max_order: found 1.5, expected a whole number from 1 to 5"},
    {"output.bodies=yes", "output.bodies: found \"yes\", expected true or false"},
    {"end_time=\"2\"", "end_time: found \"2\", expected a number"},
    // Out of range.
    {"end_time=0", "end_time: found 0, expected a number above 0"},
    {"end_time=1e300", "end_time: found 1e+300, expected a number"},
    {"materials.rock.density=0", "materials.rock.density: found 0, expected a number above 0"},
    {"materials.rock.youngs_modulus=-1", "materials.rock.youngs_modulus: found -1, expected"},
    {"materials.rock.friction=-0.1", "materials.rock.friction: found -0.1, expected a number not below 0"},
    {"materials.rock.kinetic_friction=-1",
     "materials.rock.kinetic_friction: found -1, expected a number not below 0"},
    {"materials.rock.kinetic_friction=0.6",
     "materials.rock.kinetic_friction: found 0.6, expected at most the friction, 0.5"},
    {"pairs=[{\"materials\":[\"rock\",\"rock\"],\"friction\":0.3,\"kinetic_friction\":0.4}]",
     "pairs.0.kinetic_friction: found 0.4, expected at most the pair's friction, 0.3"},
    {"materials.rock.tangential_ratio=0", "materials.rock.tangential_ratio: found 0, expected"},
    {"shapes.crate.box=[1,1,0]", "shapes.crate.box.2: found 0, expected a number above 0"},
    {"shapes.ball.sphere=-1", "shapes.ball.sphere: found -1, expected a number above 0"},
    {"shapes.floor.half_space.normal=[0,0,0]",
     "shapes.floor.half_space.normal: found [0,0,0], expected a "
     "vector that is not zero"},
    {"shapes.s={\"mesh\":\"a.obj\",\"scale\":0}", "shapes.s.scale: found 0, expected a number above 0"},
    {"shapes.s={\"mesh\":\"a.obj\",\"scale\":[1,1,-1]}", "shapes.s.scale.2: found -1, expected"},
    {"shapes.s={\"mesh\":\"\"}", "shapes.s.mesh: found \"\", expected a name"},
    {"shapes.s={}", "shapes.s: found no kind of shape, expected one of"},
    {"shapes.s={\"box\":[1,1,1],\"sphere\":1}", "shapes.s: found \"box\" and \"sphere\", expected one"},
    {"bodies.1.orientation=[0,0,0,0]", "bodies.1.orientation: found [0,0,0,0], expected a quaternion"},
    {"bodies.1.position=[0,0,1e200]", "bodies.1.position.2: found 1e+200, expected a number"},
    {"bodies.1.name=\"a\\nb\"", "bodies.1.name: found \"a\\nb\", expected a name"},
    {"output.every=0", "output.every: found 0, expected a number above 0"},
    {"output.checkpoint_every=-1", "output.checkpoint_every: found -1, expected a number not below 0"},
    {"output.every=1e-12", "output.every: found more than 1e9 rows"},
    {"stepping.step=0", "stepping.step: found 0, expected a number above 0"},
    {"stepping.rtol=0", "stepping.rtol: found 0, expected a number above 0"},
    {"stepping.max_order=6", "stepping.max_order: found 6, expected a whole number from 1 to 5"},
    {"stepping.iterations=5", "stepping.iterations: found 5, expected it only with"},
    {"stepping.separating_axis=true", "stepping.separating_axis: found true, expected it only with"},
    {"stepping.friction_directions=2", "stepping.friction_directions: found 2, expected it only with"},
    {"stepping.method=verlet", "stepping: found no fixed step, expected"},
    // Names that lead nowhere, or are used twice.
    {"bodies.1.shape=crat", "bodies.1.shape: found \"crat\", expected the name of a shape"},
    {"bodies.1.material=wood", "bodies.1.material: found \"wood\", expected the name of a material"},
    {"bodies.1.name=ground", "bodies.1: found the name \"ground\" again, expected a name of its own"},
    {"bodies.1.name=ball.0", "bodies.2: found the name \"ball.0\" again, expected a name of its own"},
    {"pairs=[{\"materials\":[\"rock\"]}]", "pairs.0.materials: found [\"rock\"], expected the names of two"},
    {"pairs=[{\"materials\":[\"rock\",\"ice\"]}]", "pairs.0.materials.1: found \"ice\", expected the name"},
    {"pairs=[{\"materials\":[\"rock\",\"rock\"]},{\"materials\":[\"rock\",\"rock\"]}]",
     "pairs.1.materials: found \"rock\" and \"rock\" again, expected one entry a pair"},
    {"bodies.0.motion=dynamic", "bodies.0.motion: found a half-space that is dynamic, expected \"fixed\""},
    {"bodies.0.velocity=[1,0,0]", "bodies.0.velocity: found a fixed body that moves, expected"},
    // Prescribed motion.
    {"bodies.1.motion.velocitty=[1,0,0]",
     "bodies.1.motion.velocitty: found an unknown key, expected \"velocity\""},
    {"bodies.1.motion.about=[0,0]", "bodies.1.motion.about: found [0,0], expected a list of 3 numbers"},
    {"bodies.1.motion.amplitude=-1", "bodies.1.motion.amplitude: found -1, expected a number not below 0"},
    {"bodies.1.motion.amplitude=0.1",
     "bodies.1.motion.amplitude: found an amplitude without a frequency, expected both above 0"},
    {"bodies.1.motion.frequency=10",
     "bodies.1.motion.frequency: found a frequency without an amplitude, expected both above 0"},
    {"bodies.1.motion={\"frequency\":10,\"amplitude\":0.1}",
     "bodies.1.motion.velocity: found none, expected the direction of the vibration"},
    {"bodies.1={\"shape\":\"crate\",\"material\":\"rock\",\"motion\":{},\"velocity\":[1,0,0]}",
     "bodies.1.velocity: found a prescribed body with a velocity of its own, expected it in \"motion\""},
    {"bodies.1={\"shape\":\"crate\",\"material\":\"rock\",\"motion\":{},\"angular_velocity\":[1,0,0]}",
     "bodies.1.angular_velocity: found a prescribed body with a velocity of its own, expected it in"},
    {"bodies=[]", "found no bodies, expected at least one"},
    // Fill.
    {"fill=[{\"shape\":\"ball\"}]", "fill.0: found no \"material\", expected that key"},
    {"fill=[{\"shape\":\"floor\",\"material\":\"rock\",\"count\":1,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.shape: found \"floor\", a half-space, expected a bounded shape"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":0,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.count: found 0, expected a whole number from 1 to 1000000"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1e9,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.count: found 1000000000.0, expected a whole number"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1000000,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill: found 1000003 bodies, expected 1000000 at most"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1,\"box\":[[0,0,0],[1,1,0]]}]",
     "fill.0.box: found [[0,0,0],[1,1,0]], expected the lowest corner, then the highest"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1,\"size\":[2,1],\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.size: found [2,1], expected the smaller number first"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1,\"seed\":-1,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.seed: found -1, expected a whole number not below 0"},
    // Unknown keys of every other object.
    {"pairs=[{\"materials\":[\"rock\",\"rock\"],\"frictoin\":1}]",
     "pairs.0.frictoin: found an unknown key, expected \"friction\""},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"cuont\":1,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.cuont: found an unknown key, expected \"count\""},
    {"shapes.s={\"mesh\":\"a.obj\",\"size\":1}", "shapes.s.size: found an unknown key"},
    {"bodies.1.motion.angular_velocty=[0,0,1]",
     "bodies.1.motion.angular_velocty: found an unknown key, expected \"angular_velocity\""},
    {"endtime=1", "endtime: found an unknown key, expected \"end_time\""},
    {"law.Normal=volume", "law.Normal: found an unknown key, expected \"normal\""},
    {"materials.rock.density_=1", "materials.rock.density_: found an unknown key, expected \"density\""},
    // Missing keys.
    {"materials.ice={\"density\":900,\"youngs_modulus\":1e9}", "materials.ice: found no \"friction\""},
    {"materials.ice={\"density\":900,\"friction\":0}", "materials.ice: found no \"youngs_modulus\""},
    {"materials.ice={}", "materials.ice: found no \"density\""},
    {"bodies.1={\"material\":\"rock\"}", "bodies.1: found no \"shape\""},
    {"bodies.1={\"shape\":\"crate\"}", "bodies.1: found no \"material\""},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1}]", "fill.0: found no \"box\""},
    {"shapes.s={\"half_space\":{}}", "shapes.s.half_space: found no \"normal\""},
    {"pairs=[{\"friction\":1}]", "pairs.0: found no \"materials\""},
    // More wrong kinds and ranges.
    {"bodies.1=null", "bodies.1: found null, expected an object"},
    {"bodies.1.motion=null", "bodies.1.motion: found null, expected \"dynamic\", \"fixed\" or an object"},
    {"bodies.1.motion=[]", "bodies.1.motion: found [], expected"},
    {"bodies.1.shape=3", "bodies.1.shape: found 3, expected a name"},
    {"bodies.1.name=\"\"", "bodies.1.name: found \"\", expected a name"},
    {"bodies.1.orientation=[1,0,0]", "bodies.1.orientation: found [1,0,0], expected a list of 4 numbers"},
    {"bodies.1.velocity=1", "bodies.1.velocity: found 1, expected a list of 3 numbers"},
    {"bodies.1.motion.velocity=[0,0,1e31]", "bodies.1.motion.velocity.2: found 1e+31, expected a number"},
    {"shapes.ball.sphere=1e-31", "shapes.ball.sphere: found 1e-31, expected a number above 0"},
    {"shapes.ball=0.05", "shapes.ball: found 0.05, expected an object"},
    {"shapes.crate.box=0.1", "shapes.crate.box: found 0.1, expected a list of 3 numbers"},
    {"shapes.s={\"mesh\":\"a.obj\",\"scale\":[1,1]}", "shapes.s.scale: found [1,1], expected a list of 3"},
    {"shapes.s={\"mesh\":7}", "shapes.s.mesh: found 7, expected a name"},
    {"shapes.s={\"mesh\":\"a.obj\",\"parts\":\"all\"}", "shapes.s.parts: found \"all\", expected one of"},
    {"pairs={}", "pairs: found an object, expected a list"},
    {"fill=3", "fill: found 3, expected a list"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1.5,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.count: found 1.5, expected a whole number"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1,\"box\":[[0,0,0]]}]",
     "fill.0.box: found [[0,0,0]], expected the lowest and the highest corner"},
    {"fill=[{\"shape\":\"stone\",\"material\":\"rock\",\"count\":1,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.shape: found \"stone\", expected the name of a shape"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"ice\",\"count\":1,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.material: found \"ice\", expected the name of a material"},
    {"stepping=bdf", "stepping: found \"bdf\", expected an object"},
    {"stepping.method=rk4", "stepping.method: found \"rk4\", expected one of \"bdf\""},
    {"stepping.step=-1e-3", "stepping.step: found -0.001, expected a number above 0"},
    {"stepping.rtol=2", "stepping.rtol: found 2, expected a number above 0 and at most 1"},
    {"stepping.atol=-1", "stepping.atol: found -1, expected a number above 0"},
    {"stepping={\"method\":\"bullet\",\"friction_directions\":3}",
     "stepping.friction_directions: found 3, expected 1 or 2"},
    {"stepping={\"method\":\"bullet\",\"iterations\":0}",
     "stepping.iterations: found 0, expected a whole number from 1 to 1000000"},
    {"stepping={\"method\":\"symplectic_euler\",\"step\":\"adaptive\"}", "stepping: found no fixed step"},
    {"end_time=-2", "end_time: found -2, expected a number above 0"},
    {"end_time=null", "end_time: found null, expected a number"},
    {"output=[]", "output: found [], expected an object"},
    {"output.every=\"0.1\"", "output.every: found \"0.1\", expected a number"},
    // Runs that would never end.
    {"stepping.step=1e-14", "stepping.step: found more than 1e12 steps to make, expected a longer step"},
    {"bodies.1.angular_velocity=[0,1e30,0]",
     "bodies.1.angular_velocity: found more than 1e12 radians to turn, expected a slower turn"},
    {"bodies.1.motion={\"angular_velocity\":[0,0,1e14]}",
     "bodies.1.motion.angular_velocity: found more than 1e12 radians to turn, expected a slower turn"},
    {"bodies.1.motion={\"velocity\":[0,0,1],\"amplitude\":1,\"frequency\":1e14}",
     "bodies.1.motion.frequency: found more than 1e12 periods, expected a slower vibration"},
    // Settings themselves.
    {"end_time", "--set \"end_time\": found no key and value, expected KEY=VALUE"},
    {"=3", "--set \"=3\": found no key and value, expected KEY=VALUE"},
    {"law..normal=3", "--set \"law..normal=3\": found an empty part of the path"},
    {"bodies.3.name=x", "--set \"bodies.3.name=x\": found \"3\", expected a number from 0 to 2"},
    {"end_time.unit=s", "--set \"end_time.unit=s\": found 0.1, expected an object or a list"},
    {"law={\"normal\":1,\"normal\":1}",
     "--set \"law={\\\"normal\\\":1,\\\"normal\\\":1}\": normal: found the key twice"},
};

const std::vector<BadSetting> absent_settings = {
#ifndef SCREE_HAS_VTK
    {"output.vtk=true", "output.vtk: found true, which is not in this build"},
#endif
};

std::vector<BadScene> spoiled(std::span<const BadSetting> settings) {
    std::vector<BadScene> scenes;
    for (const auto& [setting, message] : settings) {
        scenes.push_back({small_scene, setting, message});
    }
    return scenes;
}

}  // namespace

std::vector<BadScene> bad_texts() {
    std::vector<BadScene> scenes;
    for (const auto& [text, message] : bad_text_table) {
        scenes.push_back({text, "", message});
    }
    return scenes;
}

std::vector<BadScene> bad_values() {
    return spoiled(bad_settings);
}

std::vector<BadScene> absent_values() {
    return spoiled(absent_settings);
}

}  // namespace scree::test
