#include <scree/output/gltf.hpp>

#include <assimp/scene.h>
#include <assimp/Exporter.hpp>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "glb_file.hpp"

namespace scree {

namespace {

const aiMatrix4x4 z_up_to_y_up{1, 0,  0, 0,  //
                               0, 0,  1, 0,  //
                               0, -1, 0, 0,  //
                               0, 0,  0, 1};

// Muted, and easy to tell apart; ground is grey.
constexpr float palette[][3] = {{0.62F, 0.48F, 0.36F}, {0.36F, 0.50F, 0.62F}, {0.70F, 0.62F, 0.42F},
                                {0.45F, 0.58F, 0.42F}, {0.60F, 0.40F, 0.42F}, {0.50F, 0.46F, 0.60F}};
constexpr float ground_colour[] = {0.75F, 0.75F, 0.75F};
constexpr std::size_t ground_corners = 6;

// The exporter takes names for identifiers, and loses channels of nodes whose names other things have too.
constexpr std::string_view safe_name = "body ";

std::string safe_node_name(std::size_t body) {
    return std::string(safe_name) + std::to_string(body);
}

aiVector3D vector_of(const Vec3& v) {
    const Eigen::Vector3f f = v.cast<float>();
    return {f.x(), f.y(), f.z()};
}

aiQuaternion quaternion_of(const Quat& q) {
    const Eigen::Quaternionf f = q.cast<float>();
    return {f.w(), f.x(), f.y(), f.z()};
}

/// Takes over what is new'd into one of assimp's arrays.
template <class T>
void give(std::vector<std::unique_ptr<T>> items, T**& array, unsigned& count) {
    count = static_cast<unsigned>(items.size());
    array = new T*[items.size()];
    std::transform(items.begin(), items.end(), array, [](auto& item) { return item.release(); });
}

std::unique_ptr<aiMaterial> material_of(const ShownMesh& mesh, std::size_t number) {
    const float* rgb =
        mesh.corners.size() == ground_corners ? ground_colour : palette[number % std::size(palette)];
    const aiColor4D colour(rgb[0], rgb[1], rgb[2], 1);
    constexpr float rough = 0.9F;
    constexpr float metallic = 0;
    auto material = std::make_unique<aiMaterial>();
    material->AddProperty(&colour, 1, AI_MATKEY_BASE_COLOR);
    material->AddProperty(&rough, 1, AI_MATKEY_ROUGHNESS_FACTOR);
    material->AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
    return material;
}

std::unique_ptr<aiMesh> mesh_of(const ShownMesh& shown, std::size_t number) {
    auto mesh = std::make_unique<aiMesh>();
    const auto count = static_cast<unsigned>(shown.corners.size());
    mesh->mMaterialIndex = static_cast<unsigned>(number);
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh->mNumVertices = count;
    mesh->mVertices = new aiVector3D[count];
    mesh->mNormals = new aiVector3D[count];
    mesh->mNumFaces = count / 3;
    mesh->mFaces = new aiFace[count / 3];
    for (unsigned i = 0; i < count; ++i) {
        mesh->mVertices[i] = vector_of(shown.corners[i].position);
        mesh->mNormals[i] = vector_of(shown.corners[i].normal);
        aiFace& face = mesh->mFaces[i / 3];
        if (i % 3 == 0) {
            face.mNumIndices = 3;
            face.mIndices = new unsigned[3];
        }
        face.mIndices[i % 3] = i;
    }
    return mesh;
}

aiMatrix4x4 matrix_of(const Pose& pose, double size) {
    const auto factor = static_cast<float>(size);
    return {aiVector3D(factor, factor, factor), quaternion_of(pose.orientation), vector_of(pose.position)};
}

std::unique_ptr<aiNode> node_of(const ShownBody& body, std::size_t number, const Pose& pose) {
    auto node = std::make_unique<aiNode>(safe_node_name(number));
    node->mTransformation = matrix_of(pose, body.size);
    node->mNumMeshes = 1;
    node->mMeshes = new unsigned[1]{static_cast<unsigned>(body.mesh)};
    return node;
}

std::unique_ptr<aiScene> assimp_scene(const ShownScene& shown, std::span<const Pose> poses) {
    auto scene = std::make_unique<aiScene>();
    std::vector<std::unique_ptr<aiMesh>> meshes;
    std::vector<std::unique_ptr<aiMaterial>> materials;
    for (std::size_t i = 0; i < shown.meshes.size(); ++i) {
        meshes.push_back(mesh_of(shown.meshes[i], i));
        materials.push_back(material_of(shown.meshes[i], i));
    }
    give(std::move(meshes), scene->mMeshes, scene->mNumMeshes);
    give(std::move(materials), scene->mMaterials, scene->mNumMaterials);
    scene->mRootNode = new aiNode("world");
    scene->mRootNode->mTransformation = z_up_to_y_up;
    std::vector<std::unique_ptr<aiNode>> nodes;
    for (std::size_t i = 0; i < shown.bodies.size(); ++i) {
        nodes.push_back(node_of(shown.bodies[i], i, poses[i]));
        nodes.back()->mParent = scene->mRootNode;
    }
    give(std::move(nodes), scene->mRootNode->mChildren, scene->mRootNode->mNumChildren);
    return scene;
}

std::unique_ptr<aiNodeAnim> channel_of(std::size_t body, std::size_t keys) {
    auto channel = std::make_unique<aiNodeAnim>();
    channel->mNodeName = safe_node_name(body);
    channel->mPositionKeys = new aiVectorKey[keys];
    channel->mRotationKeys = new aiQuatKey[keys];
    return channel;
}

// Keys that follow one another take the same side, so that a viewer turns the short way between them.
void add_key(double time, const Pose& pose, aiNodeAnim& channel) {
    aiQuaternion turn = quaternion_of(pose.orientation);
    if (channel.mNumRotationKeys > 0) {
        const aiQuaternion& last = channel.mRotationKeys[channel.mNumRotationKeys - 1].mValue;
        if (turn.w * last.w + turn.x * last.x + turn.y * last.y + turn.z * last.z < 0) {
            turn = {-turn.w, -turn.x, -turn.y, -turn.z};
        }
    }
    channel.mPositionKeys[channel.mNumPositionKeys++] = aiVectorKey(time, vector_of(pose.position));
    channel.mRotationKeys[channel.mNumRotationKeys++] = aiQuatKey(time, turn);
}

std::vector<std::unique_ptr<aiNodeAnim>> channels_of(const ShownScene& scene, const PoseSpool& spool,
                                                     std::size_t stride, std::vector<double>& contacts) {
    std::vector<std::unique_ptr<aiNodeAnim>> channels;
    const std::size_t keys = spool.frames() / stride + 2;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        if (scene.bodies[b].moves) {
            channels.push_back(channel_of(b, keys));
        }
    }
    spool.read(stride, [&](double time, double touching, std::span<const Pose> poses) {
        contacts.push_back(touching);
        for (std::size_t i = 0; i < channels.size(); ++i) {
            add_key(time, poses[i], *channels[i]);
        }
    });
    return channels;
}

void animate(std::vector<std::unique_ptr<aiNodeAnim>> channels, aiScene& scene) {
    std::vector<std::unique_ptr<aiAnimation>> animations;
    animations.push_back(std::make_unique<aiAnimation>());
    aiAnimation& animation = *animations.back();
    animation.mName = "run";
    animation.mTicksPerSecond = 1;
    const aiNodeAnim& first = *channels.front();
    animation.mDuration = first.mPositionKeys[first.mNumPositionKeys - 1].mTime;
    give(std::move(channels), animation.mChannels, animation.mNumChannels);
    give(std::move(animations), scene.mAnimations, scene.mNumAnimations);
}

/// Names nodes as their bodies and meshes as their shapes.
void put_names(const ShownScene& shown, nlohmann::ordered_json& json) {
    for (auto& node : json["nodes"]) {
        if (const auto name = node["name"].get<std::string>(); name.starts_with(safe_name)) {
            node["name"] = shown.bodies.at(std::stoul(name.substr(safe_name.size()))).name;
        }
    }
    for (std::size_t i = 0; i < json["meshes"].size() && i < shown.meshes.size(); ++i) {
        json["meshes"][i]["name"] = shown.meshes[i].name;
    }
    json.erase("extensionsUsed");  // none is
}

GlbFile exported(const aiScene& scene, const ShownScene& shown) {
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, "glb2");
    if (blob == nullptr) {
        throw std::runtime_error(std::string("no glTF could be made: ") + exporter.GetErrorString());
    }
    GlbFile file({static_cast<const char*>(blob->data), blob->size});
    put_names(shown, file.json);
    return file;
}

std::vector<Pose> starts(const ShownScene& scene) {
    std::vector<Pose> poses;
    for (const ShownBody& body : scene.bodies) {
        poses.push_back(body.start);
    }
    return poses;
}

}  // namespace

std::string replay_glb(const ShownScene& scene, const PoseSpool& spool, std::size_t most_poses) {
    const auto moving = static_cast<std::size_t>(std::count_if(
        scene.bodies.begin(), scene.bodies.end(), [](const ShownBody& body) { return body.moves; }));
    const std::unique_ptr<aiScene> world = assimp_scene(scene, starts(scene));
    const bool animated = moving > 0 && spool.frames() > 0;
    std::vector<double> contacts;
    if (animated) {
        const std::size_t stride = 1 + spool.frames() * moving / std::max<std::size_t>(most_poses, 1);
        animate(channels_of(scene, spool, stride, contacts), *world);
    }
    GlbFile file = exported(*world, scene);
    if (animated) {
        file.json["animations"][0]["extras"]["contacts"] = contacts;
    }
    return file.bytes();
}

}  // namespace scree
