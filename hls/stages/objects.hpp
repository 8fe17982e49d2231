// SPDX-License-Identifier: Apache-2.0
// objects: joins occupied pixels, those in the skin and those that are blind, to objects (8-connected, one pass) and says of
// each its pixels, how many of them are blind, the area of skin that they see, box and sums of places. The thesis counts pixels of the whole image (10.4.6); an object is found wherever
// it is, however large the image.
//
// Labelling by runs, after Bailey and Johnston (Single Pass Connected Components Analysis, IVCNZ 2007): only the runs of
// the row above that are still to come, and those of the row so far, have a label. These stand in registers, so that where
// two objects meet all labels of the one become those of the other at once: no equivalences are kept. What an object
// consists of stands in a memory. Where a run ends, meets one of the row above, or passes it, this is written to a queue,
// and worked off in 2·GAP beats.
//
// In      the pixels of the result in raster order: occupied or not; first, last of a row; `area`, the code of the area that
//         it sees (horopter/hls/area.hpp); blind, of an occupied one. After the frame: beats with `idle`, not pixels,
//         until `done`; the objects that reach the last row end in these.
// Config  object_limit: pixels of an object that are an alarm. object_area_limit: area of one, 1/1024 mm², that is; all
//         ones: none is, not even the largest.
// Out     ended: an object has; its pixels, the blind ones of these, its area (1/1024 mm², or the largest), its box (columns
//         and rows, inclusive), the sums of its columns and rows.
//         alarm: an object of the frame so far has reached the limit, ended or not. overflow: more labels or a longer
//         queue were needed than there are, so objects may be wrong or missing: not an answer. Both until `first`.
//         done: in an idle beat, everything has been said.
// Illegal use: a frame that begins before `done`: what was not said is lost.
#pragma once

#include <algorithm>

#include "horopter/hls/area.hpp"
#include "stages/stream.hpp"

namespace horopter::stages {

// Bitwise: both sides are always computed. A short circuit would make a chain of choices, too long for a fast clock.
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wbitwise-instead-of-logical"

/// Bit i: set[i].
template <std::size_t N>
constexpr u<N> word_of(const std::array<bool, N>& set) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < N; ++i) word |= std::uint64_t{set[i]} << i;
  return u<N>(word);
}

/// LABELS: runs of the row above still to come and of the row so far, together. GAP: beats from an access of the objects'
/// memory to the next.
template <int WIDTH, int HEIGHT, std::size_t LABELS, int GAP>
class ObjectFinder {
 public:
  using Count = u<bits_for(WIDTH* HEIGHT)>;
  using Column = u<bits_for(WIDTH - 1)>;
  using Row = u<bits_for(HEIGHT - 1)>;
  using ColumnSum = u<bits_for(WIDTH* HEIGHT) + bits_for(WIDTH - 1)>;
  using RowSum = u<bits_for(WIDTH* HEIGHT) + bits_for(HEIGHT - 1)>;

  struct In {
    bool occupied = false;
    bool first = false;
    bool last = false;
    bool idle = false;
    u<8> area;
    bool blind = false;
  };
  struct Config {
    Count object_limit;
    ObjectArea object_area_limit;
  };
  struct Object {
    Count pixels, blind;
    ObjectArea area;
    Column left, right;
    Row top, bottom;
    ColumnSum columns;  // sum over its pixels
    RowSum rows;
  };
  struct Out {
    bool ended = false;
    Object object;
    bool alarm = false;
    bool overflow = false;
    bool done = false;
  };

  Out step(const In& in, const Config& config) {
    above_.begin_step();
    queue_.begin_step();
    objects_.begin_step();
    const bool first = in.first && !in.idle;
    const bool little_room = !first & (room_ != 0) & (room_ < 8);
    const Address room(read_ - write_);
    Out out;
    bool reached = false;
    if (at_rest(first)) {
      full_ = false;
      if (phase_ == take_at) take(in.idle);
    } else {
      reached = keep_objects(out, config);
      work_off(in.idle, first);
    }
    alarm_ = (alarm_ && !first) || reached;
    look(in, first);
    little_room_ = little_room;
    room_ = first ? Address(0) : room;
    phase_ = Phase(phase_ + lit<1>());
    overflow_ = (overflow_ && !first) || full_ || queue_full_;
    out.alarm = alarm_;
    out.overflow = overflow_;
    out.done = in.idle && done_;
    return out;
  }

#ifndef __HLSC__
  /// For an engine that leaves out beats in which nothing happens: those of a row, neither its first nor its last, whose
  /// pixels are in the skin, or not, as is the one before them, and the same of the pixels above. `rests`: nothing is to be
  /// done but that. `pixels` of such beats, none of them blind, stand for as
  /// many calls of step. `area`: the sum of area_of of them.
  [[nodiscard]] bool rests() const {
    return at_rest(false) && read_ == write_ && visible_ == write_ && room_ == 0 && !little_room_ && !ended_ &&
           (met_ || !before_ || !over_before_);
  }
  void skip(int pixels, std::uint32_t area) {
    full_ = queue_full_ = false;
    if (before_ != over_before_) {
      for (int i = 0; i < pixels; ++i) {
        above_.begin_step();
        above_.write(raster_.step(false, false).column, before_);
      }
    } else {
      raster_.skip(pixels);
    }
    if (before_) {
      last_run_.right = Column(last_run_.right + u<bits_for(WIDTH - 1)>(pixels));
      last_run_.area += u<32>(area);
    }
    phase_ = Phase(phase_ + u<16>(pixels));
  }
#endif

 private:
  static constexpr int slot = 2 * GAP;  // beats for an event
  static constexpr std::size_t queue_length = 2 * LABELS;
  // When in a slot an event is taken, and what is done with it. What lies beyond the end is in the next slot's first beats.
  static constexpr int take_at = 0, find_at = 1, compare_at = 2, change_at = 3, leave_at = 4 % slot;
  static constexpr int first_access_at = change_at, second_access_at = (change_at + GAP) % slot;
  using Phase = u<bits_for(slot - 1)>;
  static_assert(slot >= 4 && slot == 1 << bits_for(slot - 1));
  using Label = u<bits_for(LABELS - 1)>;
  using Address = u<bits_for(queue_length - 1)>;

  using Place = std::array<bool, LABELS>;  // one of them
  static Place first_place() {
    Place place{};
    place[0] = true;
    return place;
  }
  static Place after(const Place& place) {
    Place next{};
    for (std::size_t i = 0; i < LABELS; ++i) next[(i + 1) % LABELS] = place[i];
    return next;
  }

  /// Label of a run, or none.
  struct Entry {
    Label label{0};
    bool there = false;
  };
  /// The one at a place, by halves.
#ifndef __HLSC__
  static Entry chosen(const std::array<Entry, LABELS>& entries, const Place& place) { return entries[place_of(place)]; }
  static std::size_t place_of(const Place& place) {
    return static_cast<std::size_t>(std::find(place.begin(), place.end(), true) - place.begin());
  }
#else
  static Entry chosen(std::array<Entry, LABELS> entries, const Place& place) {
    for (std::size_t i = 0; i < LABELS; ++i) {
      if (!place[i]) entries[i] = Entry{};
    }
    for (std::size_t half = 1; half < LABELS; half *= 2) {
      for (std::size_t i = 0; i < LABELS; i += 2 * half) {
        entries[i].label = entries[i].label | entries[i + half].label;
        entries[i].there = entries[i].there | entries[i + half].there;
      }
    }
    return entries[0];
  }
#endif
  static bool same(const Entry& a, const Entry& b) { return a.there & b.there & (a.label == b.label); }

  static constexpr std::size_t group = 4;
  using Groups = std::array<bool, LABELS / group>;  // one of them
  using Group = u<bits_for(LABELS / group - 1)>;

  struct Run {
    Column left, right;
    Row row;
    u<bits_for(WIDTH) + PixelArea::width> area;
    u<bits_for(WIDTH)> blind;
  };

  /// In this order: the run ends, the next one meets the first run of the row above, that one is passed.
  struct Event {
    bool ends = false;
    bool meets = false;
    bool passes = false;
    Run run;
  };

  // --- pixels to events ----------------------------------------------------------------------------------------------

  void look(const In& in, bool first) {
    bool here = false, over = false, edge = true;
    Column x = last_run_.right;
    if (!in.idle) {
      const auto at = raster_.step(in.first, in.last);
      here = in.occupied;
      over = above_.read(at.column) == 1 && !at.frame_start_row;
      above_.write(at.column, here);
      edge = at.row_start;
      x = at.column;
    }
    if (first) met_ = ended_ = before_ = over_before_ = false;
    // A window of 2×2 pixels: one run of the row above at most, and one of this row. At a row's first pixel it is the end
    // of the row before; what this pixel meets is seen with the second one.
    const bool next = here && !edge, next_over = over && !edge;
    Event event;
    event.ends = ended_ || (edge && before_);
    event.passes = over_before_ && !next_over;
    queue_full_ = false;
    event.run = last_run_;
    const bool touch = (over_before_ || next_over) && (before_ || next) && !edge;
    const bool met = met_ && !event.ends;
    event.meets = touch && !met;
    if (event.ends || event.meets || event.passes) {
      queue_full_ = little_room_;
      if (!little_room_) {
        queue_.write(write_, event);
        write_ = Address(write_ + lit<1>());
      }
    }
    if (first) write_ = Address(0);
    met_ = (met || touch) && !event.passes;
    ended_ = before_ && !here && !edge;
    if (!in.idle && edge) row_ = first ? Row(0) : Row(row_ + lit<1>());
    if (here) {
      const bool begins = edge || !before_;
      if (begins) {
        last_run_.left = x;
        last_run_.area = last_run_.blind = 0;
      }
      last_run_.area += area_of(in.area);
      last_run_.blind += u<1>(in.blind);
      last_run_.right = x;
      last_run_.row = row_;
    }
    before_ = here;
    over_before_ = over;
  }

  /// Nothing but a look into the queue is to be done: what is left out changes nothing. Only the CPU gains by that.
  [[nodiscard]] bool at_rest([[maybe_unused]] bool first) const {
#ifdef __HLSC__
    return false;
#else
    return !first && !busy_ && !second_ && free_.there && found_.there && !looked_there_;
#endif
  }

  // --- events to labels ----------------------------------------------------------------------------------------------

  /// Flat, and from what the step before has left: no part of it waits for another one.
  void work_off(bool idle, bool restarts) {
    const bool finds = busy_ & (phase_ == find_at), compares = busy_ & (phase_ == compare_at);
    const bool changes = busy_ & (phase_ == change_at), leaves = busy_ & (phase_ == leave_at);
    const Entry run = run_, unused = free_, front = front_;

    const bool ends = finds & event_.ends, begins = ends & !run.there;
    const Label ended = run.there ? run.label : unused.label;
    if (finds) {
      front_ = chosen(entries_, begin_);
      fresh_ = !run.there;
      label_ = ended;
    }
    full_ = ends & (chosen(entries_, end_).there | (!run.there & !unused.there));

    const bool joined = joined_;
    const Place is_front = same_;
    const bool adopts = compares & event_.meets & !run.there;
    if (compares) {
      joined_ = event_.meets & run.there & front.there & (run.label != front.label);
      done_ = draining_ & !front.there;
      for (std::size_t i = 0; i < LABELS; ++i) same_[i] = same(entries_[i], front) & !begin_[i];
    }
    run_.label = adopts ? front.label : run.label;
    run_.there = !restarts & ((run.there & !ends) | (adopts & front.there));

    const bool joins = changes & joined, others = others_;
    if (changes) {
      others_ = (word_of(is_front) != 0) | same(run, front);
      other_ = joined ? run.label : front.label;
    }

    const bool passes = leaves & event_.passes & front.there;
    const bool closes = passes & !joined & !others, frees = closes | (leaves & joined);
    if (phase_ == leave_at) {
      second_ = frees;
      second_ends_ = closes;
    }

    bool reserves = false;
    const Place reserved = find_free(begins, restarts, reserves);
    const Label label = ends ? ended : run.label;
#ifndef __HLSC__
    if (ends | joins | passes | frees | restarts | reserves)
#endif
      for (std::size_t i = 0; i < LABELS; ++i) {
        const bool comes = ends & end_[i], goes = passes & begin_[i];
        if (comes | (joins & (is_front[i] | begin_[i]))) entries_[i].label = label;
        entries_[i].there = !restarts & ((entries_[i].there & !goes) | comes);
        const bool freed = frees & (front.label == static_cast<int>(i));
        used_[i] = !restarts & ((used_[i] & !freed) | reserved[i]);
      }
    if (passes | restarts) begin_ = restarts ? first_place() : after(begin_);
    if (ends | restarts) end_ = restarts ? first_place() : after(end_);
    if (restarts) {
      read_ = visible_ = Address(0);
      busy_ = done_ = false;
    } else if (phase_ == take_at) {
      take(idle);
    }
  }

  /// Looks for labels that are not used, a group in two beats, and keeps two. The result: those that it takes from now on.
  Place find_free(bool taken, bool restarts, bool& comes) {
    std::array<bool, group> first{};
    bool all_used = true;
    for (std::size_t k = 0; k < group; ++k) {
      first[k] = all_used & !looked_.bit(static_cast<int>(k));
      all_used = all_used & looked_.bit(static_cast<int>(k));
    }
    const bool looked = looked_there_ & !restarts;
    comes = looked & !all_used;
    const Entry found = found_;
    const bool moves = found.there & (taken | !free_.there);
    if (moves) free_.label = found.label;
    free_.there = !restarts & (moves | (free_.there & !taken));
    if (comes) found_.label = Label(shl<2>(at_group_) + u<1>(first[1] | first[3]) + shl<1>(u<1>(first[2] | first[3])));
    found_.there = !restarts & (comes | (found.there & !moves));
    Place reserved{};
    u<group> used(0);
#ifndef __HLSC__
    const auto at = static_cast<std::size_t>(at_group_.value()) * group;  // of the only group
    for (std::size_t k = 0; k < group; ++k) reserved[at + k] = comes & first[k];
    for (std::size_t k = 0; k < group; ++k) used = used | u<group>(u<1>(used_[at + k]).value() << k);
#else
    for (std::size_t i = 0; i < LABELS; ++i) reserved[i] = comes & group_[i / group] & first[i % group];
    for (std::size_t i = 0; i < LABELS; i += group) {
      std::array<bool, group> of_group{};
      for (std::size_t k = 0; k < group; ++k) of_group[k] = used_[i + k] & group_[i / group];
      used = used | word_of(of_group);
    }
#endif
    looked_ = used;
    looked_there_ = !restarts & !looked_there_ & (!found.there | moves);
    const Groups here = group_;
    const bool advances = looked & all_used;
    for (std::size_t i = 0; i < here.size(); ++i) {
      group_[i] = restarts ? i == 0 : advances ? here[(i + here.size() - 1) % here.size()] : here[i];
    }
    at_group_ = restarts ? Group(0) : Group(at_group_ + u<1>(advances));
    return reserved;
  }

  /// With the frame's end, the runs of its last row are passed, one by one.
  void take(bool idle) {
    const bool more = read_ != visible_;
    draining_ = idle && !more && read_ == write_ && !before_ && !over_before_ && !ended_;
    busy_ = more || draining_;
    event_.ends = event_.meets = false;
    event_.passes = true;
    if (more) {
      event_ = queue_.read(read_);
      read_ = Address(read_ + lit<1>());
    }
    visible_ = write_;
  }

  // --- labels to objects ---------------------------------------------------------------------------------------------

  /// First a run is added, or the object that joins another one is read. Then it is added to that one; or an object that
  /// has ended is read.
  bool keep_objects(Out& out, const Config& config) {
    const bool second = (phase_ == second_access_at) & second_;
    const bool first = (phase_ == first_access_at) & busy_ & (joined_ | event_.ends);
    const bool changes = second ? !second_ends_ : !joined_;
    const bool fresh = first & fresh_;
    const Object run = of(event_.run);
    const Object joining = joining_;
    const Object added = second ? joining : run;
    bool reached = false;
    if (first | second) {
      const Label label(second ? other_.value() : joined_ ? front_.label.value() : label_.value());
      const Object object = objects_.read(label);
      const Object changed = fresh ? run : together(object, added);
      if (changes) objects_.write(label, changed);
      joining_ = object;
      out.object = object;
      const bool covers = (changed.area >= config.object_area_limit) & (config.object_area_limit != ObjectArea::max());
      reached = changes & ((changed.pixels >= config.object_limit) | covers);
    }
    out.ended = second & second_ends_;
    return reached;
  }

  static Object of(const Run& run) {
    Object object;
    const auto pixels = u<bits_for(WIDTH)>(run.right - run.left + lit<1>());
    object.pixels = Count(pixels);
    object.blind = run.blind;
    object.area = ObjectArea(run.area);
    object.left = run.left;
    object.right = run.right;
    object.top = object.bottom = run.row;
    object.columns = ColumnSum(shr<1>(pixels * (run.left + run.right)));
    object.rows = RowSum(pixels * run.row);
    return object;
  }
  static Object together(const Object& a, const Object& b) {
    Object both;
    both.pixels = Count(a.pixels + b.pixels);
    both.blind = Count(a.blind + b.blind);
    both.area = area_sum(a.area, b.area);
    both.left = a.left < b.left ? a.left : b.left;
    both.right = a.right < b.right ? b.right : a.right;
    both.top = a.top < b.top ? a.top : b.top;
    both.bottom = a.bottom < b.bottom ? b.bottom : a.bottom;
    both.columns = in_halves(a.columns, b.columns);
    both.rows = in_halves(a.rows, b.rows);
    return both;
  }
  /// a + b, which a fast clock does not add at once.
  template <int N>
  static u<N> in_halves(u<N> a, u<N> b) {
    const auto low = a.template bits<15, 0>() + b.template bits<15, 0>();
    const auto high = a.template bits<N - 1, 16>() + b.template bits<N - 1, 16>() + low.template bits<16, 16>();
    return u<N>(shl<16>(high) + low.template bits<15, 0>());
  }

  Raster<WIDTH, 1> raster_;
  ColumnMemory<u<1>, WIDTH> above_;
  bool before_ = false, over_before_ = false;  // the pixel to the left, and the one above it
  bool ended_ = false;                         // the run before this pixel's left neighbour
  bool met_ = false;                           // the run in progress has met the first one of the row above
  Row row_{0};
  Run last_run_;

  RAM<Event, queue_length, slot> queue_;
  Address write_{0}, read_{0}, visible_{0};  // visible: written long enough ago
  Address room_{0};                          // of a step before; 0: all
  bool little_room_ = false;
  Phase phase_{0};
  bool busy_ = false, draining_ = false, done_ = false;
  Event event_;

  std::array<Entry, LABELS>
      entries_{};  // from begin_ to end_, in the order of columns: of the row above, then of this row
  Place begin_ = first_place(), end_ = first_place();
  Entry run_;                        // of the run in progress
  std::array<bool, LABELS> used_{};  // labels
  Entry free_, found_;               // two of the others, where they have been found
  Groups group_{true};               // of labels, where the next one is looked for
  Group at_group_{0};
  u<group> looked_{0};  // whether its labels are used
  bool looked_there_ = false;
  Entry front_;                      // the first run of the row above
  Label label_{0};                   // of the run that has ended
  bool fresh_ = false;               // that has met none
  std::array<bool, LABELS> same_{};  // other runs of the object of front_
  bool others_ = false;              // one of them, or the run in progress
  bool joined_ = false;              // the object of front_ has become run_'s
  Label other_{0};                   // the object of the second access, if there is one
  bool second_ = false, second_ends_ = false;
  bool full_ = false, queue_full_ = false, overflow_ = false;

  RAM<Object, LABELS, GAP> objects_;
  Object joining_;
  bool alarm_ = false;
};

#pragma clang diagnostic pop

template <Profile P>
using Objects = ObjectFinder<P.result_width(), P.height, 32, (P.clock_khz > 50'000 ? 8 : 2)>;

}  // namespace horopter::stages
