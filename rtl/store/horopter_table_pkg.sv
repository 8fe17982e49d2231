// SPDX-License-Identifier: Apache-2.0
// Made by scripts/generate-profiles from hls/include/horopter/hls/table_format.hpp: change that, not this.
// The format of mapping tables.
package horopter_table_pkg;
  localparam int unsigned MAGIC = 'h484D;  // "HM"
  localparam int unsigned VERSION = 3;  // of the format
  localparam int unsigned SLOTS = 15;  // tables that a machine holds, from 0; the next number means none
  localparam int unsigned SMALLEST_RESULT_WIDTH = 32;  // px of a frame's result that a machine takes
  localparam int unsigned SMALLEST_HEIGHT = 16;  // rows of it
  localparam int unsigned HEADER_WORDS = 4;  // before the facts
  localparam int unsigned FACT_WORDS = 5;  // before the areas
  localparam int unsigned LARGEST_SPACING_LOG2 = 6;  // of control points
  localparam int unsigned AREA_BLOCK_LOG2 = 5;  // side of a block that has one area
  localparam int unsigned UNKNOWN_AREA = 'hFF;  // code of a pixel's, where a table knows none: the largest
  localparam int unsigned CONTROL_OFFSET_PX = 64;  // control points are unsigned: 0 means -64 px
  localparam int unsigned CONTROL_SCALE = 32;  // steps per pixel
  localparam int unsigned AROUND_SKIN = 'hA000;  // y of points around the skin, from here on
  localparam int unsigned UNMAPPED = 'hFFFFFFFF;  // a control point without a source
endpackage
