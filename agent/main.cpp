// SPDX-License-Identifier: BSD-3-Clause
// k3d-agent: program entry.
int main() { return 0; }
