// SPDX-License-Identifier: BSD-3-Clause
#include "common/config/walk.h"

#include <limits>

namespace k3d::config {

namespace {

constexpr Range kAny{-std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity()};

class Walker final : public Fields {
  public:
    Walker(const OnField& on_field, const OnSection& on_section)
        : on_field_(on_field), on_section_(on_section) {}

    void number(std::string_view key, double& value, Range range, std::string_view unit,
                std::string_view meaning) override {
        on_field_({path_of(key), &value, range, unit, nullptr, meaning});
    }
    void integer(std::string_view key, int& value, Range range, std::string_view unit,
                 std::string_view meaning) override {
        on_field_({path_of(key), &value, range, unit, nullptr, meaning});
    }
    void seed(std::string_view key, std::uint64_t& value, std::string_view meaning) override {
        on_field_({path_of(key), &value, kAny, "", nullptr, meaning});
    }
    void boolean(std::string_view key, bool& value, std::string_view meaning) override {
        on_field_({path_of(key), &value, kAny, "", nullptr, meaning});
    }
    void text(std::string_view key, std::string& value, const std::vector<std::string>& choices,
              std::string_view meaning) override {
        on_field_({path_of(key), &value, kAny, "", &choices, meaning});
    }
    void numbers(std::string_view key, std::vector<double>& value, Range range,
                 std::string_view unit, std::string_view meaning) override {
        on_field_({path_of(key), &value, range, unit, nullptr, meaning});
    }

  protected:
    void begin_section(std::string_view key) override {
        section_ = path_of(key);
        on_section_(section_);
    }
    void end_section() override { section_ = std::string(section_of(section_)); }

  private:
    std::string path_of(std::string_view key) const {
        return section_.empty() ? std::string(key) : section_ + "." + std::string(key);
    }

    const OnField& on_field_;
    const OnSection& on_section_;
    std::string section_;
};

}  // namespace

void walk(const Describe& describe, const OnField& on_field, const OnSection& on_section) {
    Walker walker(on_field, on_section);
    describe(walker);
}

std::string_view section_of(std::string_view path) {
    const auto dot = path.rfind('.');
    return dot == std::string_view::npos ? std::string_view{} : path.substr(0, dot);
}

std::string_view key_of(std::string_view path) {
    const auto dot = path.rfind('.');
    return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

}  // namespace k3d::config
