// SPDX-License-Identifier: BSD-3-Clause
// A text file that a run is asked to write: opened before anything is served, and no loss goes
// unheard.
#pragma once

#include <fstream>
#include <string>
#include <string_view>

namespace k3d::server::recording {

class OutputFile {
  public:
    enum class Begin { Anew, BehindWhatIsThere };

    /// `what` names its content in errors. Throws std::runtime_error, e.g. "cannot write results to
    /// /no/such/results.jsonl: No such file or directory".
    OutputFile(std::string what, std::string file, Begin begin);

    /// The text is out when this returns. Throws like the constructor, when the disk is full, say.
    void write(std::string_view text);

  private:
    void check();

    std::string what_;
    std::string name_;
    std::ofstream file_;
};

}  // namespace k3d::server::recording
