// SPDX-License-Identifier: Apache-2.0
// Following objects from frame to frame: who is who, how old, how fast. Rectangles stand for objects.
#include "horopter/machine/object_tracker.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace horopter {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A rectangle about a centre, with a place in space of 2 mm for a pixel.
SkinObject body(double x, double y, int width = 40, int height = 60) {
  SkinObject object;
  object.region = {static_cast<int>(std::lround(x - width / 2.0)),
                   static_cast<int>(std::lround(y - height / 2.0)),
                   width,
                   height,
                   std::int64_t{width} * height,
                   x,
                   y,
                   0};
  object.in_space = ObjectInSpace{4.0 * width * height, 2.0 * height, 2.0 * width, {2 * x, 2 * y, 800}};
  return object;
}

/// What two bodies that touch are to the machine.
SkinObject both(const SkinObject& a, const SkinObject& b) {
  const Region &r = a.region, &s = b.region;
  SkinObject object;
  const int x = std::min(r.x, s.x), y = std::min(r.y, s.y);
  const auto pixels = static_cast<double>(r.pixels + s.pixels);
  object.region = {
      x,
      y,
      std::max(r.x + r.width, s.x + s.width) - x,
      std::max(r.y + r.height, s.y + s.height) - y,
      r.pixels + s.pixels,
      (r.centroid_x * static_cast<double>(r.pixels) + s.centroid_x * static_cast<double>(s.pixels)) / pixels,
      (r.centroid_y * static_cast<double>(r.pixels) + s.centroid_y * static_cast<double>(s.pixels)) / pixels,
      0};
  return object;
}

bool touch(const SkinObject& a, const SkinObject& b) {
  const Region &r = a.region, &s = b.region;
  return r.x <= s.x + s.width && s.x <= r.x + r.width && r.y <= s.y + s.height && s.y <= r.y + r.height;
}

std::vector<TrackedObject> follow(ObjectTracker& tracker, const std::vector<SkinObject>& objects) {
  return tracker.follow(objects);
}

}  // namespace

TEST_CASE("The first frame: new objects in their order, of which no motion is known") {
  ObjectTracker tracker;
  const auto found = follow(tracker, {body(100, 100), body(300, 200)});
  REQUIRE(found.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(found[i].id == static_cast<int>(i) + 1);
    CHECK(found[i].age_frames == 1);
    CHECK_FALSE(found[i].motion);
  }
  CHECK(found[1].region.centroid_x == 300);
  CHECK(found[1].in_space->length_mm == 120);
}

TEST_CASE("Nothing is nothing, and what comes after it is new") {
  ObjectTracker tracker;
  for (int i = 0; i < 3; ++i) CHECK(follow(tracker, {}).empty());
  CHECK(follow(tracker, {body(50, 50)}).at(0).id == 1);
}

TEST_CASE("An object that moves keeps its id, and its velocity is that of its centre") {
  ObjectTracker tracker;
  TrackedObject last;
  for (int frame = 0; frame < 10; ++frame) {
    // As far in a frame as it is wide.
    last = follow(tracker, {body(60 + 38.0 * frame, 200 - 11.0 * frame)}).at(0);
    CHECK(last.id == 1);
    CHECK(last.age_frames == frame + 1);
    CHECK(last.motion.has_value() == (frame > 0));
  }
  CHECK((last.motion->px_frame - Vector2d(38, -11)).norm() < 1e-9);
  REQUIRE(last.motion->mm_frame);
  CHECK((*last.motion->mm_frame - Vector3d(76, -22, 0)).norm() < 1e-9);
  CHECK_FALSE(last.motion->frame_s);
  CHECK_FALSE(last.motion->mm_s());
  CHECK_FALSE(last.motion->px_s());
}

TEST_CASE("With times there are velocities by the second, also where frames come unevenly") {
  ObjectTracker tracker;
  std::optional<ObjectMotion> motion;
  for (const double time_s : {100.0, 100.04, 100.12, 100.16}) {
    const std::vector<SkinObject> objects{body(50 + 500 * (time_s - 100), 100)};
    motion = tracker.follow(objects, Scan::progressive, time_s).at(0).motion;
  }
  REQUIRE(motion);
  REQUIRE(motion->mm_s());
  CHECK(motion->mm_s()->x() == Approx(1000));
  CHECK(motion->px_s()->x() == Approx(500));
  // A clock that stands or goes back says no velocity.
  ObjectTracker standing;
  for (const double time_s : {5.0, 5.0, 4.0}) {
    const std::vector<SkinObject> objects{body(50, 100)};
    motion = standing.follow(objects, Scan::progressive, time_s).at(0).motion;
  }
  REQUIRE(motion);
  CHECK_FALSE(motion->px_s());
}

TEST_CASE("Without a place in space there is a velocity in pixels alone") {
  ObjectTracker tracker;
  SkinObject object = body(50, 50);
  follow(tracker, {object});
  object = body(53, 50);
  object.in_space.reset();
  const auto motion = follow(tracker, {object}).at(0).motion;
  REQUIRE(motion);
  CHECK(motion->px_frame.x() == Approx(3));
  CHECK_FALSE(motion->mm_frame);
}

TEST_CASE("Objects that cross each other keep their ids, whatever order they come in") {
  const double speed = GENERATE(8.0, 12.0, 23.0);
  const bool turned = GENERATE(false, true);
  const int second_width = GENERATE(40, 70);
  CAPTURE(speed, turned, second_width);
  ObjectTracker tracker;
  int id_a = 0, id_b = 0, joined = 0, apart_again = 0;
  for (int frame = 0; 100 + speed * frame < 560; ++frame) {
    CAPTURE(frame);
    const SkinObject a = body(100 + speed * frame, 200);
    const SkinObject b = body(560 - speed * frame, 215, second_width);
    if (touch(a, b)) {
      const auto found = follow(tracker, {both(a, b)});
      REQUIRE(found.size() == 1);
      CHECK((found[0].id == id_a || found[0].id == id_b));
      CHECK_FALSE(found[0].motion);  // the centroid of two is no place of either
      ++joined;
      continue;
    }
    const auto found = turned ? follow(tracker, {b, a}) : follow(tracker, {a, b});
    REQUIRE(found.size() == 2);
    const TrackedObject& is_a = found[turned ? 1 : 0];
    const TrackedObject& is_b = found[turned ? 0 : 1];
    if (frame == 0) {
      id_a = is_a.id;
      id_b = is_b.id;
    }
    CHECK(is_a.id == id_a);
    CHECK(is_b.id == id_b);
    CHECK(is_a.age_frames == frame + 1);
    CHECK(is_b.age_frames == frame + 1);
    apart_again += joined > 0 ? 1 : 0;
    if (frame > 0 && (joined == 0 || apart_again > 1)) {
      REQUIRE(is_a.motion);
      CHECK(is_a.motion->px_frame.x() == Approx(speed));
      REQUIRE(is_b.motion);
      CHECK(is_b.motion->px_frame.x() == Approx(-speed));
    }
  }
  CHECK(joined >= 1);
  CHECK(apart_again >= 3);
}

TEST_CASE("Of two that pass side by side without touching each keeps its id") {
  ObjectTracker tracker;
  for (int frame = 0; frame < 20; ++frame) {
    const auto found = follow(tracker, {body(100 + 15.0 * frame, 100, 40, 40), body(385 - 15.0 * frame, 145, 40, 40)});
    CHECK(found[0].id == 1);
    CHECK(found[1].id == 2);
  }
}

TEST_CASE("Where one object becomes two, the part that is nearest keeps the id; the other is new") {
  ObjectTracker tracker;
  for (int frame = 0; frame < 5; ++frame) follow(tracker, {body(200 + 2.0 * frame, 200, 120, 60)});
  const auto found = follow(tracker, {body(245, 200, 50, 60), body(185, 200, 60, 60)});
  REQUIRE(found.size() == 2);
  CHECK(((found[0].id == 1) != (found[1].id == 1)));
  CHECK(((found[0].id == 2) != (found[1].id == 2)));
  // What came off is no motion.
  for (const TrackedObject& part : found) CHECK_FALSE(part.motion);
  const auto after = follow(tracker, {body(247, 200, 50, 60), body(187, 200, 60, 60)});
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(after[i].id == found[i].id);
    REQUIRE(after[i].motion);
    CHECK(after[i].motion->px_frame.x() == Approx(2));
  }
}

TEST_CASE("A speck that comes off an object does not stop its velocity") {
  ObjectTracker tracker;
  for (int frame = 0; frame < 5; ++frame) follow(tracker, {body(200 + 5.0 * frame, 200)});
  const auto found = follow(tracker, {body(225, 200, 40, 58), body(225, 232, 4, 4)});
  CHECK(found[0].id == 1);
  REQUIRE(found[0].motion);
  CHECK(found[0].motion->px_frame.x() == Approx(5));
}

TEST_CASE("Two that stay joined are one: in the end it has a velocity again, and nobody waits for the other") {
  ObjectTracker tracker;
  int id = 0;
  std::optional<ObjectMotion> motion;
  for (int frame = 0; frame < 80; ++frame) {
    const SkinObject a = body(std::min(100 + 10.0 * frame, 182.0) + 2 * std::max(0, frame - 10), 200);
    const SkinObject b = body(220 + 2.0 * std::max(0, frame - 10), 200);
    const auto found = touch(a, b) ? follow(tracker, {both(a, b)}) : follow(tracker, {a, b});
    if (touch(a, b)) {
      REQUIRE(found.size() == 1);
      if (id == 0) id = found[0].id;
      CHECK(found[0].id == id);
      motion = found[0].motion;
    }
  }
  REQUIRE(motion);
  CHECK(motion->px_frame.x() == Approx(2));
}

TEST_CASE("An object that is lost for some frames keeps its id; for longer it is another one") {
  for (const auto& [frames, same] :
       {std::pair{1, true}, {ObjectTracker::kLost_images, true}, {ObjectTracker::kLost_images + 1, false}}) {
    CAPTURE(frames);
    ObjectTracker tracker;
    for (int frame = 0; frame < 4; ++frame) follow(tracker, {body(100 + 20.0 * frame, 100)});
    for (int i = 0; i < frames; ++i) CHECK(follow(tracker, {}).empty());
    const auto found = follow(tracker, {body(100 + 20.0 * (4 + frames), 100)});
    CHECK(found.at(0).id == (same ? 1 : 2));
    CHECK(found.at(0).age_frames == (same ? 5 + frames : 1));
  }
}

TEST_CASE("What appears far from where an object was is another one") {
  ObjectTracker tracker;
  follow(tracker, {body(100, 100)});
  CHECK(follow(tracker, {body(500, 100)}).at(0).id == 2);
  // An id is never given again.
  for (int i = 0; i < 20; ++i) follow(tracker, {});
  CHECK(follow(tracker, {body(100, 100)}).at(0).id == 3);
}

TEST_CASE("One object for one id: of two that claim it the one of the frame before has it") {
  ObjectTracker tracker;
  for (int i = 0; i < 3; ++i) follow(tracker, {body(100, 100), body(150, 100)});
  for (int i = 0; i < 3; ++i) CHECK(follow(tracker, {body(100, 100)}).at(0).id == 1);  // 2 is gone
  // Halfway between both places: nearer to 2's, but 1 was there in the frame before.
  CHECK(follow(tracker, {body(128, 100)}).at(0).id == 1);
}

TEST_CASE("Of fields velocities are from even to even and from odd to odd ones") {
  ObjectTracker tracker(2);
  for (int frame = 0; frame < 12; ++frame) {
    const int image = frame / 2;
    const bool odd = frame % 2 == 1;
    // Both fields taken at once, and each sees it elsewhere: on its own rows.
    const std::vector<SkinObject> objects{body(100 + 10.0 * image, odd ? 99.5 : 100)};
    const auto found = tracker.follow(objects, odd ? Scan::odd_field : Scan::even_field, frame / 50.0).at(0);
    CHECK(found.id == 1);
    CHECK(found.age_frames == frame + 1);
    REQUIRE(found.motion.has_value() == (frame >= 2));
    if (frame < 2) continue;
    CHECK((found.motion->px_frame - Vector2d(5, 0)).norm() < 1e-9);
    CHECK(found.motion->px_s()->x() == Approx(250));
  }
}

TEST_CASE("Hundreds of objects at once keep their ids, and none has two") {
  ObjectTracker tracker;
  std::vector<int> ids;
  for (int frame = 0; frame < 6; ++frame) {
    std::vector<SkinObject> objects;
    for (int i = 0; i < 300; ++i) {
      const int column = i % 30, row = i / 30;
      objects.push_back(body(10 + 20 * column + frame, 10 + 20 * row, 8, 8));
    }
    const auto found = follow(tracker, objects);
    std::vector<int> now;
    for (const TrackedObject& object : found) now.push_back(object.id);
    if (frame == 0) ids = now;
    CHECK(now == ids);
  }
}

}  // namespace horopter
