// SPDX-License-Identifier: BSD-3-Clause
#include "common/config/convert.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "common/config/text.h"
#include "common/sexpr/writer.h"

namespace k3d::config {

namespace {

std::string type_name(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a section";
        case toml::node_type::array:
            return "a list";
        case toml::node_type::string:
            return "a text";
        case toml::node_type::integer:
            return "a whole number";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

std::string wrong_type(const toml::node& node, std::string_view wanted) {
    return "is " + type_name(node) + ", wanted is " + std::string(wanted);
}

std::string out_of_range(double value, Range range) {
    if (value >= range.min && value <= range.max) return {};
    std::string text = "is ";
    sexpr::append_exact(value, text);
    return text + ", allowed is " + range_text(range);
}

std::string check_number(const toml::node& node, Range range, double& value) {
    if (!node.is_number()) return wrong_type(node, "a number");
    value = *node.value<double>();
    if (!std::isfinite(value)) return "is not finite";
    return out_of_range(value, range);
}

/// Each overload checks a value for one kind of field and leaves it in `value`.
struct Check {
    const Field& field;
    const toml::node& node;

    std::string operator()(double& value) const { return check_number(node, field.range, value); }

    std::string operator()(int& value) const {
        const auto* integer = node.as_integer();
        if (integer == nullptr) return wrong_type(node, "a whole number");
        const Range limits{std::max<double>(field.range.min, std::numeric_limits<int>::min()),
                           std::min<double>(field.range.max, std::numeric_limits<int>::max())};
        const std::string fault = out_of_range(static_cast<double>(integer->get()), limits);
        if (fault.empty()) value = static_cast<int>(integer->get());
        return fault;
    }

    std::string operator()(std::uint64_t& value) const {
        // TOML's whole numbers end at 2^63 - 1; seeds beyond stand in quotes.
        const auto* text = node.as_string();
        const auto* integer = node.as_integer();
        if (text == nullptr && integer == nullptr) return wrong_type(node, "a whole number");
        const std::string digits = text != nullptr ? text->get() : std::to_string(integer->get());
        const char* const end = digits.data() + digits.size();
        const auto [stop, fault] = std::from_chars(digits.data(), end, value);
        if (fault == std::errc{} && stop == end) return {};
        return "is " + digits + ", allowed is 0 to 18446744073709551615";
    }

    std::string operator()(bool& value) const {
        const auto* boolean = node.as_boolean();
        if (boolean == nullptr) return wrong_type(node, "true or false");
        value = boolean->get();
        return {};
    }

    std::string operator()(std::string& value) const {
        const auto* text = node.as_string();
        if (text == nullptr) return wrong_type(node, "a text in quotes");
        value = text->get();
        const auto& choices = *field.choices;
        if (choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end()) {
            return {};
        }
        std::string fault = "is " + quoted(value) + ", allowed is";
        for (const std::string& choice : choices) fault += " " + quoted(choice);
        return fault;
    }

    std::string operator()(std::vector<double>& value) const {
        const auto* array = node.as_array();
        if (array == nullptr) return wrong_type(node, "a list of numbers");
        if (array->size() != value.size()) {
            return "has " + std::to_string(array->size()) + " entries, wanted are " +
                   std::to_string(value.size());
        }
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string fault = check_number(*array->get(i), field.range, value[i]);
            if (!fault.empty()) return "entry " + std::to_string(i + 1) + " " + fault;
        }
        return {};
    }
};

}  // namespace

std::string assign(const Field& field, const toml::node& node, bool store) {
    return std::visit(
        [&](auto* target) {
            auto value = *target;
            std::string fault = Check{field, node}(value);
            if (fault.empty() && store) *target = std::move(value);
            return fault;
        },
        field.value);
}

}  // namespace k3d::config
