// SPDX-License-Identifier: Apache-2.0
// Made by scripts/generate-profiles from hls/include/horopter/hls/profiles.def: change that, not this.
// The profile `vga`.
package horopter_profile_pkg;
  localparam int unsigned WIDTH = 640;  // largest width of the incoming images, px
  localparam int unsigned HEIGHT = 480;  // largest height, rows
  localparam int unsigned SUBSAMPLE = 1;  // pixels of a row that are averaged to one
  localparam int unsigned DSAD_WINDOW = 9;  // side of the DSAD window, px
  localparam int unsigned MAJORITY_WINDOW = 7;  // side of the majority window, px
  localparam int unsigned WEIGHT_BITS = 3;  // bits of an interpolation weight
  localparam int unsigned STORE_ROWS = 128;  // rows of the right image's ring
  localparam int unsigned POOL_BYTES = 81920;  // pool of the mapping tables
  localparam int unsigned HYPOTHESES = 1;  // hypotheses compared at once
  localparam int unsigned PLANES = 19;  // parallel skins that compete
  localparam int unsigned SUM_ROWS = 7;  // rows of the window in which compete sums costs
  localparam int unsigned SUM_COLUMNS = 9;  // columns of the window in which compete sums costs, px
  localparam int unsigned BALLOT_REACH = 9;  // rows above and below that vote in compete
  localparam int unsigned PATHS = 1;  // 1: the pixel above helps in compete
  localparam int unsigned CLOCK_KHZ = 25175;  // clock the profile is meant for
  localparam bit THESIS = 1'b1;  // has the rule `thesis`
  localparam bit COMPETE = 1'b1;  // has the rule `compete`
  localparam int unsigned OFFSET = 2 + (DSAD_WINDOW - 1) / 2 + (MAJORITY_WINDOW - 1) / 2;  // a state belongs to the px this far up and left of the beat
  localparam int unsigned FLUSH_ROWS = OFFSET + 1;  // rows after the last of a frame that empty the windows
  localparam int unsigned CELL = WIDTH > 1024 ? 16 : 8;  // side of the cells on whose means whole images are compared, px
  localparam int unsigned COMPETE_OFFSET = 1 + (SUM_ROWS - 1) / 2 + BALLOT_REACH + (MAJORITY_WINDOW - 1) / 2;  // rows, as OFFSET, with `compete`
  localparam int unsigned COMPETE_FLUSH_ROWS = COMPETE_OFFSET + 3;  // as FLUSH_ROWS, with `compete`
endpackage
