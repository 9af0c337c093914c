// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with an experiment, each fault with its place, to be told all at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "optimizer/spec/experiment.h"

namespace k3d::optimizer::spec {

class Faults {
  public:
    /// Of a file's text, and what is said beside it.
    Faults(std::string_view toml, std::string file, const Overrides& overrides)
        : toml_(toml), file_(std::move(file)), overrides_(overrides) {}

    /// `path` is where the fault stands: its line, or that of the section it is missing from.
    void add(std::string path, const std::string& text);
    /// Throws config::ConfigError with a line for each.
    void throw_if_any() const;

    /// Whether anything is said of the value or section at `path`, in the file or beside it.
    bool is_said(const std::string& path) const;
    bool is_overridden(const std::string& path) const;

  private:
    std::string_view toml_;
    std::string file_;
    const Overrides& overrides_;
    std::vector<std::string> faults_;
};

/// Adds what no single value of the experiment can tell.
void find_faults(const Experiment& experiment, Faults& faults);

}  // namespace k3d::optimizer::spec
