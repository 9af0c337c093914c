// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/spec/agent_fields.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "optimizer/spec/ask.h"

namespace k3d::optimizer::spec {

namespace {

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
    const std::string path = program_path(program, "k3d-agent");
    const Answer answer = ask({path, "--print-fields"});
    if (!answer.exit || answer.exit->code != 0) {
        throw std::runtime_error(fmt::format("{} --print-fields: {}: {}", path,
                                             answer.exit ? answer.exit->text() : "no end",
                                             answer.text));
    }
    return parse_agent_fields(answer.text);
}

}  // namespace k3d::optimizer::spec
