// SPDX-License-Identifier: BSD-3-Clause
// k3d-optimizer: program entry.
int main() { return 0; }
