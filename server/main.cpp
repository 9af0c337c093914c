// SPDX-License-Identifier: BSD-3-Clause
// k3d-server: program entry.
int main() { return 0; }
