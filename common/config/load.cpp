// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/config/config.h"
#include "common/config/convert.h"
#include "common/config/stray.h"
#include "common/config/text.h"

namespace k3d::config {

namespace {

struct Fault {
    toml::source_index line;
    std::string text;
};

std::string unknown_key(std::string_view path, const std::vector<std::string>& known) {
    std::string text = "unknown key \"" + std::string(path) + "\"";
    const std::string hint = nearest(path, known);
    if (!hint.empty()) text += ", the nearest known one is \"" + hint + "\"";
    return text;
}

/// The value at a path; null if there is none.
const toml::node* find(const toml::table& root, std::string_view path) {
    const toml::table* table = &root;
    for (;;) {
        const auto dot = path.find('.');
        const toml::node* node = table->get(path.substr(0, dot));
        if (node == nullptr || dot == std::string_view::npos) return node;
        table = node->as_table();
        if (table == nullptr) return nullptr;
        path.remove_prefix(dot + 1);
    }
}

/// Adds a fault for every key that no field or section has.
void find_unknown(const toml::table& table, const std::string& prefix,
                  const std::vector<std::string>& known, std::vector<Fault>& faults) {
    for (const auto& [key, node] : table) {
        const std::string path = prefix + std::string(key.str());
        if (key.str().find('.') != std::string_view::npos ||
            std::find(known.begin(), known.end(), path) == known.end()) {
            faults.push_back({key.source().begin.line, unknown_key(path, known)});
        } else if (const toml::table* inner = node.as_table()) {
            find_unknown(*inner, path + ".", known, faults);
        }
    }
}

std::vector<Fault> find_faults(const Describe& describe, const toml::table& root) {
    std::vector<Fault> faults;
    std::vector<std::string> known;
    const auto on_field = [&](const Field& field) {
        known.push_back(field.path);
        const toml::node* node = find(root, field.path);
        if (node == nullptr) return;
        const std::string fault = assign(field, *node, false);
        if (!fault.empty()) {
            faults.push_back({node->source().begin.line, "\"" + field.path + "\" " + fault});
        }
    };
    const auto on_section = [&](const std::string& path) {
        known.push_back(path);
        const toml::node* node = find(root, path);
        if (node != nullptr && !node->is_table()) {
            faults.push_back(
                {node->source().begin.line, "\"" + path + "\" is a value, wanted is a section"});
        }
    };
    walk(describe, on_field, on_section);
    find_unknown(root, "", known, faults);
    return faults;
}

std::string at(std::string_view file, toml::source_index line) {
    return std::string(file) + ":" + std::to_string(line) + ": ";
}

toml::table parse(std::string_view text, std::string_view file) {
    if (const auto line = stray_letter_line(text)) {
        throw ConfigError(at(file, static_cast<toml::source_index>(*line)) +
                          "a letter beyond ASCII stands outside quotes and comments");
    }
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw ConfigError(at(file, error.source().begin.line) + std::string(error.description()));
    }
}

/// As flags give it, for as_toml() to read; none of a date or a list of anything but numbers.
std::optional<std::string> bare_text(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
    if (const auto* number = node.as_floating_point()) return number_text(number->get());
    if (const auto* yes = node.as_boolean()) return yes->get() ? "true" : "false";
    const toml::array* list = node.as_array();
    if (list == nullptr) return std::nullopt;
    std::string text;
    for (const toml::node& item : *list) {
        const auto said = item.is_number() ? bare_text(item) : std::nullopt;
        if (!said) return std::nullopt;
        text += (text.empty() ? "[" : ", ") + *said;
    }
    return text.empty() ? "[]" : text + "]";
}

void add_assignments(const toml::table& table, const std::string& prefix, std::string_view file,
                     std::vector<std::string>& out) {
    for (const auto& [key, node] : table) {
        const std::string path = prefix + std::string(key.str());
        if (const toml::table* inner = node.as_table()) {
            add_assignments(*inner, path + ".", file, out);
        } else if (const auto text = bare_text(node)) {
            out.push_back(path + "=" + *text);
        } else {
            throw ConfigError(at(file, node.source().begin.line) + "\"" + path +
                              "\" has a value of a kind that no setting has");
        }
    }
}

std::string read_file(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw ConfigError(path + ": cannot read: it is a directory");
    }
    std::ifstream in(path, std::ios::binary);
    if (!in) throw ConfigError(path + ": cannot read: " + std::strerror(errno));
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Flags give bare text: what needs quotes or brackets in TOML gets them here.
std::string as_toml(const Field& field, std::string_view value) {
    if (std::holds_alternative<std::string*>(field.value)) return quoted(value);
    if (std::holds_alternative<std::uint64_t*>(field.value)) return quoted(value);
    if (std::holds_alternative<std::vector<double>*>(field.value) && !value.starts_with('[')) {
        return "[" + std::string(value) + "]";
    }
    return std::string(value);
}

/// What is wrong with a flag's value; empty if it was stored.
std::string set_field(const Field& field, std::string_view value) {
    try {
        const std::string text = "value = " + as_toml(field, value);
        if (stray_letter_line(text)) return "is " + quoted(value) + ", which is no value";
        const toml::table table = toml::parse(text);
        const toml::node* node = table.get("value");
        if (table.size() == 1 && node != nullptr) return assign(field, *node, true);
    } catch (const toml::parse_error&) {
        // Falls through: the parser's words are about TOML, not about a flag.
    }
    return "is " + quoted(value) + ", which is no value";
}

}  // namespace

void load_text(const Describe& describe, std::string_view toml, std::string_view file) {
    const toml::table root = parse(toml, file);
    std::vector<Fault> faults = find_faults(describe, root);
    if (!faults.empty()) {
        std::stable_sort(faults.begin(), faults.end(),
                         [](const Fault& a, const Fault& b) { return a.line < b.line; });
        std::string text;
        for (const Fault& fault : faults) {
            if (!text.empty()) text += '\n';
            text += at(file, fault.line) + fault.text;
        }
        throw ConfigError(text);
    }
    const auto store = [&root](const Field& field) {
        if (const toml::node* node = find(root, field.path)) assign(field, *node, true);
    };
    walk(describe, store, [](const std::string&) {});
}

void load_file(const Describe& describe, const std::string& path) {
    load_text(describe, read_file(path), path);
}

std::vector<std::string> assignments(std::string_view toml, std::string_view file) {
    std::vector<std::string> out;
    add_assignments(parse(toml, file), "", file, out);
    return out;
}

std::vector<std::string> assignments_of_file(const std::string& path) {
    return assignments(read_file(path), path);
}

std::optional<int> line_of(std::string_view toml, std::string_view path) {
    try {
        const toml::table root = parse(toml, "");
        const toml::node* node = find(root, path);
        if (node == nullptr) return std::nullopt;
        return static_cast<int>(node->source().begin.line);
    } catch (const ConfigError&) {
        return std::nullopt;
    }
}

std::optional<std::string> text_at(std::string_view toml, std::string_view path) {
    try {
        const toml::table root = parse(toml, "");
        const toml::node* node = find(root, path);
        if (node == nullptr || !node->is_string()) return std::nullopt;
        return node->as_string()->get();
    } catch (const ConfigError&) {
        return std::nullopt;
    }
}

void set(const Describe& describe, std::string_view path, std::string_view value) {
    std::vector<std::string> known;
    bool found = false;
    std::string fault;
    const auto on_field = [&](const Field& field) {
        known.push_back(field.path);
        if (field.path != path) return;
        found = true;
        fault = set_field(field, value);
    };
    const auto on_section = [&](const std::string& section) {
        if (section != path) return;
        found = true;
        fault = "is a section, wanted is a value in it";
    };
    walk(describe, on_field, on_section);
    if (!found) throw ConfigError(unknown_key(path, known));
    if (!fault.empty()) throw ConfigError("\"" + std::string(path) + "\" " + fault);
}

}  // namespace k3d::config
