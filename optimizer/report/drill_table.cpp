// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/report/drill_table.h"

#include <fmt/format.h>

#include <map>

#include "common/math/sample.h"
#include "optimizer/report/statistics.h"

namespace k3d::optimizer::report {

namespace {

std::string cell(const std::optional<double>& value) {
    return value ? fmt::format("{:10.3f}", *value) : fmt::format("{:>10}", "-");
}

std::string row(const std::string& name, const std::vector<double>& sample) {
    const Statistics s = statistics(sample);
    return fmt::format("{:<28}{:>5}{}{}{}{}{}{}\n", name, s.n, cell(s.mean), cell(s.sd), cell(s.se),
                       cell(quantile(sample, 0.05)), cell(quantile(sample, 0.5)),
                       cell(quantile(sample, 0.95)));
}

}  // namespace

std::string drill_table(const spec::DrillSpec& spec,
                        const std::vector<k3d::episode::Result>& results) {
    const std::uint64_t seed = spec.seed + static_cast<std::uint64_t>(spec.first);
    std::string text = fmt::format("drill {}, type {}, seeds {} to {}\n", spec.name, spec.type,
                                   seed, seed + static_cast<std::uint64_t>(spec.runs) - 1);
    text += fmt::format("{:<28}{:>5}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "", "n", "mean", "sd",
                        "se", "5 %", "median", "95 %");
    std::map<std::string, std::vector<double>> samples;
    std::map<std::string, int> reasons;
    for (const auto& result : results) {
        ++reasons[result.reason];
        for (const auto& [name, value] : result.metrics) samples[name].push_back(value);
    }
    for (const auto& [name, sample] : samples) text += row(name, sample);
    text += "ended by:";
    for (const auto& [reason, count] : reasons) text += fmt::format(" {} {}", reason, count);
    if (results.size() != static_cast<std::size_t>(spec.runs)) {
        text += fmt::format("\nruns with a valid result: {} of {}", results.size(), spec.runs);
    }
    return text + "\n";
}

}  // namespace k3d::optimizer::report
