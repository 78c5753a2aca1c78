// SPDX-License-Identifier: Apache-2.0
// Counts what the global allocator is asked for; AllocationCount.cpp replaces it in this program.
#pragma once

namespace kelpie {

void startCountingAllocations();
int stopCountingAllocations();  // how many there were

}  // namespace kelpie
