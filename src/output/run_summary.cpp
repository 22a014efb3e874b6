#include <scree/output/run_summary.hpp>

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include <scree/output/energy_csv.hpp>
#include <scree/version.hpp>

namespace scree {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

Json json_of(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json json_of(const BodyRecord& body) {
    const Quat& q = body.pose.orientation;
    return {{"name", body.name},
            {"position", json_of(body.pose.position)},
            {"orientation", {q.w(), q.x(), q.y(), q.z()}},
            {"velocity", json_of(body.velocity)},
            {"angular_velocity", json_of(body.angular_velocity)}};
}

Json json_of(const RunSummary::Times& time) {
    return {{"wall", time.wall},
            {"detection", time.detection},
            {"contacts", time.contacts},
            {"jacobian", time.jacobian},
            {"solve", time.solve},
            {"output", time.output},
            {"other", std::max(0.0, time.wall - time.detection - time.contacts - time.jacobian - time.solve -
                                        time.output)}};
}

Json json_of(const EnergyLedger& energy) {
    Json entries;
    for (const auto& [name, entry] : ledger_entries) {
        entries[name] = energy.*entry;
    }
    return entries;
}

Json orders_json(const std::vector<std::size_t>& orders) {
    Json counts = Json::object();
    for (std::size_t i = 0; i < orders.size(); ++i) {
        if (orders[i] > 0) {
            counts[std::to_string(i + 1)] = orders[i];
        }
    }
    return counts;
}

Json steps_json(const RunSummary::Steps& steps) {
    return {{"accepted", steps.accepted},
            {"rejected_error", steps.rejected_error},
            {"rejected_newton", steps.rejected_newton},
            {"rejected_contact", steps.rejected_contact}};
}

}  // namespace

std::string summary_json(const RunSummary& summary) {
    Json json;
    json["scree"] = version;
    json["scene"] = summary.scene;
    json["status"] = summary.status;
    json["message"] = summary.message;
    json["end_time"] = summary.end_time;
    json["reached"] = summary.reached;
    json["threads"] = summary.threads;
    json["time"] = json_of(summary.time);
    json["steps"] = steps_json(summary.steps);
    json["step_size"] = {{"min", json_of(summary.smallest_step)},
                         {"mean", json_of(summary.mean_step)},
                         {"max", json_of(summary.largest_step)}};
    json["orders"] = orders_json(summary.orders);
    json["newton"] = {{"iterations", summary.newton.iterations},
                      {"jacobians", summary.newton.jacobians},
                      {"factorizations", summary.newton.factorizations}};
    json["functional_iterations"] = summary.functional_iterations;
    json["contact_evaluations"] = summary.contact_evaluations;
    json["contacts"] = {{"now", summary.contacts_now}, {"most", summary.contacts_most}};
    json["largest_overlap"] = summary.largest_overlap;
    json["energy"] = json_of(summary.energy);
    json["momentum_residual"] = summary.momentum_residual;
    json["used"] = summary.used;
    json["left_out"] = summary.left_out;
    json["bodies"] = Json::array();
    for (const BodyRecord& body : summary.bodies) {
        json["bodies"].push_back(json_of(body));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool is_finished(const std::filesystem::path& file) {
    std::ifstream stream(file);
    const Json json = stream ? Json::parse(stream, nullptr, false) : Json();
    return json.is_object() && json.value("status", Json()) == "done" && json.contains("end_time") &&
           json.value("reached", Json()) == json["end_time"];
}

}  // namespace scree
