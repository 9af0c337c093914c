// SPDX-License-Identifier: BSD-3-Clause
// One daemon for one run.
#pragma once

#include <string>

namespace k3d::optimizer::ledger {

/// Holds FOLDER/lock while it lives; the system lets go of it if the process dies.
class Lock {
  public:
    /// Throws LedgerError if another process has it, and names that process.
    explicit Lock(const std::string& folder);
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    int fd_ = -1;
};

}  // namespace k3d::optimizer::ledger
