// SPDX-License-Identifier: BSD-3-Clause
// Network definitions as JSON text, with errors that name the place.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "common/network/network.h"

namespace k3d::network {
namespace {

using nlohmann::json;

constexpr std::string_view kFormat = "keepaway3d-network";
constexpr int kVersion = 1;
constexpr std::uintmax_t kMaxFileBytes = 16U << 20U;

constexpr std::array<std::pair<Activation, std::string_view>, 6> kActivations{{
    {Activation::Linear, "linear"},
    {Activation::Sigmoid, "sigmoid"},
    {Activation::Tanh, "tanh"},
    {Activation::Relu, "relu"},
    {Activation::Gauss, "gauss"},
    {Activation::Sine, "sine"},
}};

/// Reads values out of one JSON object; every error says where.
class Reader {
  public:
    Reader(const json& object, std::string source, std::string where,
           std::initializer_list<std::string_view> keys)
        : object_(object), source_(std::move(source)), where_(std::move(where)) {
        if (!object_.is_object()) fail(fmt::format("{} is not an object", where_));
        for (const auto& [key, unused] : object_.items())
            if (std::find(keys.begin(), keys.end(), key) == keys.end())
                fail(fmt::format("{} has the unknown key \"{}\"", where_, key));
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw NetworkError(fmt::format("{}: {}", source_, what));
    }
    const json& need(const char* key) const {
        const auto found = object_.find(key);
        if (found == object_.end()) fail(fmt::format("{} lacks \"{}\"", where_, key));
        return *found;
    }
    std::string text(const char* key) const {
        const json& value = need(key);
        if (!value.is_string()) fail(fmt::format("\"{}\" of {} is not a text", key, where_));
        return value.get<std::string>();
    }
    double number(const char* key) const {
        const json& value = need(key);
        if (!value.is_number()) fail(fmt::format("\"{}\" of {} is not a number", key, where_));
        return value.get<double>();
    }
    double number_or(const char* key, double otherwise) const {
        return object_.contains(key) ? number(key) : otherwise;
    }
    bool flag_or(const char* key, bool otherwise) const {
        if (!object_.contains(key)) return otherwise;
        const json& value = need(key);
        if (!value.is_boolean()) fail(fmt::format("\"{}\" of {} is not true or false", key, where_));
        return value.get<bool>();
    }
    const json& list(const char* key) const {
        const json& value = need(key);
        if (!value.is_array()) fail(fmt::format("\"{}\" of {} is not a list", key, where_));
        return value;
    }
    bool has(const char* key) const { return object_.contains(key); }

  private:
    const json& object_;
    std::string source_;
    std::string where_;
};

Activation activation_from(const Reader& reader, const std::string& name) {
    if (const auto activation = activation_named(name)) return *activation;
    reader.fail(fmt::format(
        "unknown activation \"{}\"; known: linear, sigmoid, tanh, relu, gauss, sine", name));
}

Definition from_json(const json& root, const std::string& source) {
    const Reader top(root, source, "the network",
                     {"format", "version", "description", "inputs", "outputs", "nodes", "links"});
    if (const std::string format = top.text("format"); format != kFormat)
        top.fail(fmt::format("format is \"{}\", expected \"{}\"", format, kFormat));
    if (const double version = top.number("version"); version != kVersion)
        top.fail(fmt::format("version is {}, this program reads {}", version, kVersion));

    Definition d;
    if (top.has("description")) d.description = top.text("description");
    for (const json& item : top.list("inputs")) {
        const std::string where = fmt::format("input {}", d.inputs.size() + 1);
        const Reader r(item, source, where, {"name", "offset", "scale"});
        d.inputs.push_back({r.text("name"), r.number_or("offset", 0.0), r.number_or("scale", 1.0)});
    }
    for (const json& item : top.list("outputs")) {
        if (!item.is_string())
            top.fail(fmt::format("output {} is not a text", d.outputs.size() + 1));
        d.outputs.push_back(item.get<std::string>());
    }
    for (const json& item : top.list("nodes")) {
        const std::string where = fmt::format("node {}", d.nodes.size() + 1);
        const Reader r(item, source, where, {"name", "activation", "bias"});
        const Activation activation = activation_from(r, r.text("activation"));
        d.nodes.push_back({r.text("name"), activation, r.number_or("bias", 0.0)});
    }
    for (const json& item : top.list("links")) {
        const std::string where = fmt::format("link {}", d.links.size() + 1);
        const Reader r(item, source, where, {"from", "to", "weight", "recurrent"});
        d.links.push_back(
            {r.text("from"), r.text("to"), r.number("weight"), r.flag_or("recurrent", false)});
    }
    return d;
}

}  // namespace

std::string_view name_of(Activation activation) {
    for (const auto& [value, name] : kActivations)
        if (value == activation) return name;
    return "linear";
}

std::optional<Activation> activation_named(std::string_view name) {
    for (const auto& [value, known] : kActivations)
        if (known == name) return value;
    return std::nullopt;
}

Definition parse(std::string_view text, std::string_view source) {
    const std::string name(source);
    json root;
    try {
        root = json::parse(text);
    } catch (const json::exception& error) {
        throw NetworkError(fmt::format("{}: not JSON: {}", name, error.what()));
    }
    Definition definition = from_json(root, name);
    Network check(definition, source);  // throws for what the text alone does not show
    return definition;
}

Definition load_file(const std::string& path) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error) throw NetworkError(fmt::format("{}: cannot read: {}", path, error.message()));
    if (bytes > kMaxFileBytes)
        throw NetworkError(fmt::format("{}: {} bytes, limit {}", path, bytes, kMaxFileBytes));
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw NetworkError(fmt::format("{}: cannot read", path));
    return parse(text.str(), path);
}

std::string to_json(const Definition& d) {
    nlohmann::ordered_json root;
    root["format"] = kFormat;
    root["version"] = kVersion;
    root["description"] = d.description;
    root["inputs"] = nlohmann::ordered_json::array();
    for (const Input& i : d.inputs)
        root["inputs"].push_back({{"name", i.name}, {"offset", i.offset}, {"scale", i.scale}});
    root["outputs"] = d.outputs;
    root["nodes"] = nlohmann::ordered_json::array();
    for (const Node& n : d.nodes)
        root["nodes"].push_back(
            {{"name", n.name}, {"activation", name_of(n.activation)}, {"bias", n.bias}});
    root["links"] = nlohmann::ordered_json::array();
    for (const Link& l : d.links)
        root["links"].push_back(
            {{"from", l.from}, {"to", l.to}, {"weight", l.weight}, {"recurrent", l.recurrent}});
    return root.dump(1) + "\n";
}

}  // namespace k3d::network
