// SPDX-License-Identifier: Apache-2.0
// Made by scripts/generate-registers from rtl/csr/registers.yaml: change that, not this.
//
// Fields by name: what has no bit number cannot have a wrong one. Of a register with one port for all fields <name>_t;
// of several fields that belong together, the group.
package horopter_csr_pkg;
  typedef enum logic [3:0] {  // TABLE_SELECT, FRAME_STATUS and MAP_STATUS: no table.
    NO_SLOT = 4'd15
  } no_slot_t;
  typedef enum logic [31:0] {  // RESTART: "RSTR".
    RESTART_KEY = 32'd1381192786
  } restart_key_t;

  typedef struct packed {  // from the highest bit
    logic overflow;
    logic silent;
    logic missing_start;
    logic missing_line;
    logic long_line;
    logic short_line;
  } stream_faults_t;

  typedef struct packed {  // from the highest bit
    logic frozen;
    logic constant;
    logic white;
    logic black;
  } image_faults_t;

  typedef struct packed {  // from the highest bit
    logic torn;
    image_faults_t image;
  } health_t;

  typedef struct packed {  // from the highest bit
    logic torn;
    logic unsharp;
    logic blind;
    logic parity;
    image_faults_t image;
    stream_faults_t stream;
  } camera_faults_t;

  typedef struct packed {  // from the highest bit
    logic out_of_step;
    logic overlooked;
    logic teaching;
    logic contactors;
    logic objects;
    logic restart;
    logic settings;
    logic hidden;
    logic moved;
    logic unproven;
    logic disagree;
    logic one_camera;
    logic identical_images;
    logic internal;
    logic late;
    logic too_unsupervised;
    logic too_undecidable;
    logic map_busy;
    logic map_crc;
    logic no_table;
    logic store_miss;
    logic skew;
  } machine_faults_t;

  typedef struct packed {  // from the highest bit
    logic out_of_step;
    logic overlooked;
    logic [ 1:0] unsharp;
    logic untextured;
    logic hidden;
    logic moved;
    logic unproven;
    logic disagree;
  } verdict_t;

  typedef struct packed {  // from the highest bit
    machine_faults_t machine;
    camera_faults_t right;
    camera_faults_t left;
  } faults_t;

  typedef struct packed {  // from the highest bit
    logic taught;
    logic by_itself;
    logic waiting;
    logic late;
    logic right_silent;
    logic left_silent;
    logic unsafe;
    logic safe;
    logic busy;
    logic bad_geometry;
    logic running;
  } status_t;

  typedef struct packed {  // from the highest bit
    logic fault;
    logic frame;
  } irq_enable_t;

  typedef struct packed {  // from the highest bit
    logic fault;
    logic frame;
  } irq_status_t;

  typedef struct packed {  // from the highest bit
    logic [ 3:0] frames;
    logic by_register;
    logic by_pin;
    logic by_itself;
  } interlock_t;

  typedef struct packed {  // from the highest bit
    logic [ 2:0] of;
    logic [ 2:0] needed;
  } alarm_frames_t;

  typedef struct packed {  // from the highest bit
    logic [ 3:0] boundary;
    logic [ 7:0] clear_quorum;
    logic [ 7:0] quorum;
    logic [ 3:0] similar;
    logic [ 2:0] smooth;
    logic [ 3:0] bias;
  } compete_t;

  typedef struct packed {  // from the highest bit
    logic seen;
    logic [ 3:0] slot;
    logic safe;
    logic alarm;
  } frame_status_t;

  typedef struct packed {  // from the highest bit
    logic [ 7:0] unproven_skin;
    logic [ 5:0] shift_highest;
    logic [ 5:0] shift_lowest;
    logic nearer_above;
    logic nearer_below;
    logic prove;
  } agreement_t;

  typedef struct packed {  // from the highest bit
    logic [ 7:0] hidden;
    logic [ 7:0] unproven;
    logic [ 7:0] regions;
    logic [ 7:0] explained;
  } agreement_limits_t;

  typedef struct packed {  // from the highest bit
    logic [ 7:0] on_skin_cells;
    logic [ 4:0] on_skin;
    logic [ 5:0] patches;
    logic [ 5:0] moved_half;
    logic [ 5:0] moved;
  } registration_t;

  typedef struct packed {  // from the highest bit
    logic [15:0] column;
    logic [15:0] slope;
  } epipolar_t;

  typedef struct packed {  // from the highest bit
    logic [15:0] both;
    logic [15:0] row;
  } epipolar_change_t;

  typedef struct packed {  // from the highest bit
    logic [15:0] explained;
    logic [15:0] textured;
  } frame_agreement_t;

  typedef struct packed {  // from the highest bit
    logic [15:0] nearer;
    logic [15:0] supervised;
  } frame_cells_t;

  typedef struct packed {  // from the highest bit
    logic [15:0] bad_regions;
    logic [15:0] cells;
  } frame_unproven_t;

  typedef struct packed {  // from the highest bit
    logic [11:0] cells;
    logic [19:0] sum;
  } frame_across_0_t;

  typedef struct packed {  // from the highest bit
    logic [11:0] cells;
    logic [19:0] sum;
  } frame_across_1_t;

  typedef struct packed {  // from the highest bit
    logic [11:0] cells;
    logic [19:0] sum;
  } frame_across_2_t;

  typedef struct packed {  // from the highest bit
    logic [11:0] cells;
    logic [19:0] sum;
  } frame_across_3_t;

  typedef struct packed {  // from the highest bit
    logic [ 7:0] on_skin;
    logic [ 2:0] moved;
    logic [11:0] across;
    logic [ 7:0] places;
  } frame_patches_t;

  typedef struct packed {  // from the highest bit
    logic [ 9:0] nearer;
    logic [ 9:0] explained;
    logic [ 9:0] textured;
  } frame_region_t;

  typedef struct packed {  // from the highest bit
    logic [11:0] right;
    logic [11:0] left;
  } frame_object_columns_t;

  typedef struct packed {  // from the highest bit
    logic [11:0] bottom;
    logic [11:0] top;
  } frame_object_rows_t;

  typedef struct packed {  // from the highest bit
    logic dim;
    logic [ 7:0] margin;
    logic teach;
    logic watch;
  } blocks_t;
endpackage
