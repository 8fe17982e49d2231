// SPDX-License-Identifier: Apache-2.0
// The settings of the rule `compete`: fields of the register COMPETE, with its reset values.
#pragma once

namespace horopter::hls {

struct CompeteSettings {
  int bias = 2;           // added to every vote: above 0 a doubtful pixel is rather in the skin
  int smooth = 2;         // in 4 grey levels: pixels of a row that differ by more are not alike
  int similar = 3;        // in 4 grey levels: pixels of a column that differ by more do not vote for each other
  int quorum = 1;         // smallest sum of votes that says skin
  int clear_quorum = 50;  // 8 votes: smallest sum of votes against that says clear
  int boundary = 8;       // where the skin ends, 0 … 14; measured: host/src/plan/boundary_table.def
};

}  // namespace horopter::hls
