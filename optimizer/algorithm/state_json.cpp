// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/algorithm/state_json.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace k3d::optimizer::algorithm {

using nlohmann::json;

namespace {

/// A value for a message: no longer than a line bears.
std::string shown(const json& value) {
    const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    return text.size() <= 60 ? text : text.substr(0, 60) + "...";
}

}  // namespace

json exact(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return value;  // nlohmann writes the shortest digits that read back alike
}

json exact(const std::vector<double>& values) {
    json list = json::array();
    for (const double value : values) list.push_back(exact(value));
    return list;
}

void Reader::fail(const std::string& what) const {
    throw AlgorithmError(fmt::format("{}: {}: {}", source_, path_.empty() ? "the top" : path_, what));
}

Reader Reader::operator[](const char* key) const {
    if (!value_.is_object()) fail("is not an object");
    const auto found = value_.find(key);
    if (found == value_.end()) fail(fmt::format("lacks \"{}\"", key));
    return {*found, source_, path_.empty() ? key : path_ + "." + key};
}

bool Reader::has(const char* key) const {
    if (!value_.is_object()) fail("is not an object");
    return value_.contains(key);
}

std::size_t Reader::size() const {
    if (!value_.is_array()) fail("is not a list");
    return value_.size();
}

Reader Reader::entry(std::size_t index) const {
    if (index >= size()) fail(fmt::format("has {} entries, {} are needed", size(), index + 1));
    return {value_[index], source_, fmt::format("{}[{}]", path_, index)};
}

void Reader::each(const std::function<void(const Reader&)>& read) const {
    for (std::size_t i = 0; i < size(); ++i) read(entry(i));
}

double Reader::number() const {
    if (value_.is_string()) {
        const auto word = value_.get<std::string>();
        if (word == "inf") return std::numeric_limits<double>::infinity();
        if (word == "-inf") return -std::numeric_limits<double>::infinity();
        if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    }
    if (!value_.is_number()) fail(fmt::format("{} is not a number", shown(value_)));
    return value_.get<double>();
}

double Reader::finite() const {
    const double value = number();
    if (!std::isfinite(value)) fail(fmt::format("{} is not a finite number", value));
    return value;
}

int Reader::integer(int low, int high) const {
    if (!value_.is_number_integer()) fail(fmt::format("{} is not a whole number", shown(value_)));
    if (value_.is_number_unsigned() && value_.get<std::uint64_t>() > static_cast<std::uint64_t>(
                                           std::numeric_limits<std::int64_t>::max())) {
        fail(fmt::format("is {}, allowed is {} to {}", shown(value_), low, high));
    }
    const auto value = value_.get<std::int64_t>();
    if (value < low || value > high) {
        fail(fmt::format("is {}, allowed is {} to {}", value, low, high));
    }
    return static_cast<int>(value);
}

std::uint64_t Reader::unsigned_integer() const {
    // In a value that was built, not parsed, small numbers may be signed.
    if (!value_.is_number_integer() ||
        (!value_.is_number_unsigned() && value_.get<std::int64_t>() < 0)) {
        fail(fmt::format("{} is not a whole number of at least 0", shown(value_)));
    }
    return value_.get<std::uint64_t>();
}

bool Reader::flag() const {
    if (!value_.is_boolean()) fail(fmt::format("{} is not true or false", shown(value_)));
    return value_.get<bool>();
}

std::string Reader::text() const {
    if (!value_.is_string()) fail(fmt::format("{} is not a text", shown(value_)));
    return value_.get<std::string>();
}

std::vector<double> Reader::finite_list() const {
    std::vector<double> values;
    each([&values](const Reader& entry) { values.push_back(entry.finite()); });
    return values;
}

std::vector<double> Reader::finite_list(std::size_t length) const {
    if (size() != length) fail(fmt::format("has {} entries, {} are needed", size(), length));
    return finite_list();
}

json network_json(const network::Definition& definition) {
    return json::parse(network::to_json(definition));
}

network::Definition read_network(const Reader& reader) {
    try {
        return network::parse(reader.json().dump(), "network");
    } catch (const network::NetworkError& error) {
        reader.fail(error.what());
    } catch (const json::exception& error) {  // text that is not UTF-8
        reader.fail(error.what());
    }
}

}  // namespace k3d::optimizer::algorithm
