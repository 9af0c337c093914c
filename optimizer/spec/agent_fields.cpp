// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/agent_fields.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "common/process/child.h"

namespace k3d::optimizer::spec {

namespace {

constexpr std::chrono::seconds kPatience{30};

double bound(const nlohmann::json& value, double none) {
    return value.is_null() ? none : value.get<double>();
}

AgentField number_of(const nlohmann::json& entry) {
    AgentField field;
    field.path = entry.at("path").get<std::string>();
    field.integer = entry.at("type") == "integer";
    field.value = entry.at("value").get<double>();
    field.min = bound(entry.at("min"), field.min);
    field.max = bound(entry.at("max"), field.max);
    field.unit = entry.at("unit").get<std::string>();
    field.meaning = entry.at("meaning").get<std::string>();
    return field;
}

void add_elements(const nlohmann::json& entry, AgentFields& fields) {
    const auto path = entry.at("path").get<std::string>();
    const auto values = entry.at("value").get<std::vector<double>>();
    for (std::size_t i = 0; i < values.size(); ++i) {
        AgentField field;
        field.path = fmt::format("{}.{}", path, i);
        field.value = values[i];
        field.min = bound(entry.at("min"), field.min);
        field.max = bound(entry.at("max"), field.max);
        field.unit = entry.at("unit").get<std::string>();
        fields.numbers.push_back(std::move(field));
    }
    fields.lists[path] = values;
}

/// A file of its own for what a program prints.
struct Capture {
    std::string path = (std::filesystem::temp_directory_path() / "k3d-fields-XXXXXX").string();
    Capture() {
        const int fd = ::mkstemp(path.data());
        if (fd < 0) throw std::runtime_error("cannot make a file in " + path);
        ::close(fd);
    }
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;
    ~Capture() { ::unlink(path.c_str()); }
};

}  // namespace

const AgentField* AgentFields::find(std::string_view path) const {
    for (const AgentField& field : numbers) {
        if (field.path == path) return &field;
    }
    return nullptr;
}

AgentFields parse_agent_fields(std::string_view json) {
    try {
        AgentFields fields;
        for (const nlohmann::json& entry : nlohmann::json::parse(json)) {
            const auto type = entry.at("type").get<std::string>();
            if (type == "number" || type == "integer") fields.numbers.push_back(number_of(entry));
            if (type == "numbers") add_elements(entry, fields);
            if (type == "text") fields.texts.push_back(entry.at("path").get<std::string>());
        }
        return fields;
    } catch (const nlohmann::json::exception& error) {
        throw std::runtime_error(std::string("the agent's list of settings: ") + error.what());
    }
}

AgentFields ask_agent_fields(const std::string& program) {
    const Capture said;
    process::Child child({{program_path(program, "k3d-agent"), "--print-fields"}, said.path, false});
    const auto exit = child.wait(kPatience);
    std::ostringstream text;
    text << std::ifstream(said.path).rdbuf();
    if (!exit || exit->code != 0) {
        throw std::runtime_error(fmt::format("{} --print-fields: {}: {}",
                                             program_path(program, "k3d-agent"),
                                             exit ? exit->text() : "no end", text.str()));
    }
    return parse_agent_fields(text.str());
}

std::string program_path(const std::string& wanted, const char* name) {
    if (!wanted.empty()) return wanted;
    return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

}  // namespace k3d::optimizer::spec
