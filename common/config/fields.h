// SPDX-License-Identifier: BSD-3-Clause
// Configuration as plain structs: each struct names its fields once in describe(), and loading,
// printing, range checks and paths ("walk.step_height") all follow from that.
//
//     struct WalkConfig {
//         double step_height = 0.03;
//         void describe(config::Fields& f) {
//             f.number("step_height", step_height, {0.0, 0.1}, "m", "how high the swing foot is
//             lifted");
//         }
//     };
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace k3d::config {

struct Range {
    double min;
    double max;
};

/// Visitor of one struct's fields. `unit` is "" for pure numbers, `meaning` one line.
class Fields {
  public:
    virtual ~Fields() = default;
    virtual void number(std::string_view key, double& value, Range range, std::string_view unit,
                        std::string_view meaning) = 0;
    virtual void integer(std::string_view key, int& value, Range range, std::string_view unit,
                         std::string_view meaning) = 0;
    virtual void seed(std::string_view key, std::uint64_t& value, std::string_view meaning) = 0;
    virtual void boolean(std::string_view key, bool& value, std::string_view meaning) = 0;
    /// `choices` empty: any text.
    virtual void text(std::string_view key, std::string& value,
                      const std::vector<std::string>& choices, std::string_view meaning) = 0;
    /// A list of numbers, each within range, with exactly value.size() entries.
    virtual void numbers(std::string_view key, std::vector<double>& value, Range range,
                         std::string_view unit, std::string_view meaning) = 0;

    template <class Struct>
    void section(std::string_view key, Struct& sub) {
        begin_section(key);
        sub.describe(*this);
        end_section();
    }

  protected:
    virtual void begin_section(std::string_view key) = 0;
    virtual void end_section() = 0;
};

}  // namespace k3d::config
