// SPDX-License-Identifier: Apache-2.0
// Sources of images as the monitor opens them: GigE Vision by the fake cameras of Aravis on the loopback, GStreamer, files.
#include <arv.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "../unit/host_temporary.hpp"
#include "../unit/video_hole.hpp"
#include "camera/grabbers.hpp"
#include "camera/succession.hpp"
#include "horopter/base/error.hpp"
#include "horopter/monitor/camera.hpp"

using namespace horopter::monitor;
using namespace std::chrono_literals;

namespace {

struct Unref {
  void operator()(ArvGvFakeCamera* camera) const { g_object_unref(camera); }
};
using FakeCamera = std::unique_ptr<ArvGvFakeCamera, Unref>;

FakeCamera fake_camera(const char* address, const char* serial) {
  FakeCamera camera(arv_gv_fake_camera_new(address, serial));
  REQUIRE(arv_gv_fake_camera_is_running(camera.get()));
  return camera;
}

CameraSettings settings(const std::string& source, double frames_per_s = 25) {
  CameraSettings settings;
  settings.camera.source = source;
  settings.frames_per_s = frames_per_s;
  settings.begin = Clock::now() + 500ms;  // files are open by then
  return settings;
}

/// For whom every image of files counts: they are open by then on a busy computer, too.
CameraSettings settings_of_all(const std::string& source, double frames_per_s) {
  CameraSettings all = settings(source, frames_per_s);
  all.begin = Clock::now() + 5s;
  return all;
}

/// So many whole images, each waited for as long as it takes. On a busy computer packets are lost, and an image with
/// holes comes without its pixels.
std::vector<CameraFrame> grab(Grabber& grabber, std::size_t count) {
  std::vector<CameraFrame> frames;
  std::uint64_t lost_packets = 0;
  for (const auto give_up = Clock::now() + 60s; frames.size() < count && Clock::now() < give_up;) {
    auto frame = grabber.next(100ms);
    if (!frame && grabber.ended()) break;
    if (!frame) continue;
    if (frame->image.pixels.empty()) CHECK(frame->lost_packets > lost_packets);
    lost_packets = frame->lost_packets;
    if (!frame->image.pixels.empty()) frames.push_back(std::move(*frame));
  }
  REQUIRE(frames.size() == count);
  return frames;
}

/// What is said of a source that cannot be opened.
std::string problem_of(const CameraSettings& settings) {
  try {
    open_grabber(settings);
  } catch (const CameraError& error) {
    return error.what();
  }
  return "";
}

/// Keeps what a camera's thread tells.
class Sink : public CameraSink {
 public:
  void frame(Side side, CameraFrame frame) override {
    const std::lock_guard lock(mutex_);
    frames_[side].push_back(std::move(frame));
  }
  void connected(Side /*side*/) override {
    const std::lock_guard lock(mutex_);
    ++connected_;
  }
  void lost(Side /*side*/, const std::string& why) override {
    const std::lock_guard lock(mutex_);
    lost_ = why;
  }
  void ended(Side /*side*/) override {
    const std::lock_guard lock(mutex_);
    ++ended_;
  }
  template <class Condition>
  bool wait(const Condition& condition) {
    for (const auto give_up = Clock::now() + 60s; Clock::now() < give_up; std::this_thread::sleep_for(5ms)) {
      const std::lock_guard lock(mutex_);
      if (condition(*this)) return true;
    }
    return false;
  }

  std::map<Side, std::vector<CameraFrame>> frames_;
  int connected_ = 0, ended_ = 0;
  std::string lost_;

 private:
  std::mutex mutex_;
};

struct Seen {
  std::set<std::vector<std::uint8_t>> images;
  std::vector<std::uint8_t> first;
  std::uint64_t lost = 0;
};

/// All that a pipeline with an end gives.
Seen see(const std::string& pipeline) {
  const auto grabber = open_grabber(settings(pipeline));
  Seen seen;
  try {
    for (const auto give_up = Clock::now() + 60s; Clock::now() < give_up;) {
      const auto frame = grabber->next(100ms);
      if (!frame) continue;
      seen.lost = frame->lost_packets;
      if (frame->image.empty()) continue;
      if (seen.images.empty()) seen.first = frame->image.pixels;
      seen.images.insert(frame->image.pixels);
    }
  } catch (const CameraError& error) {
    CHECK_THAT(error.what(), Catch::Contains("the stream has ended"));
  }
  return seen;
}

}  // namespace

TEST_CASE("a GigE Vision camera by its address: features, serial number, counts and exposure") {
  const FakeCamera camera = fake_camera("127.0.0.1", "L1");
  auto with_features = settings("gev:127.0.0.1");
  with_features.camera.features = {{"Height", "120"}, {"Width", "160"}, {"ExposureTimeAbs", "4000"}};
  const auto grabber = open_grabber(with_features);
  const auto frames = grab(*grabber, 4);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    CAPTURE(i);
    CHECK(frames[i].image.width == 160);
    CHECK(frames[i].image.height == 120);
    CHECK(frames[i].serial == "L1");
    CHECK(frames[i].exposure_us == Approx(4000));
    REQUIRE(frames[i].number);
    if (i > 0) CHECK(*frames[i].number > *frames[i - 1].number);
    if (i > 0) CHECK(frames[i].taken > frames[i - 1].taken);
  }
  CHECK(frames.front().image.pixels != frames.back().image.pixels);
}

TEST_CASE("a camera by its serial number; one that is not there, and what it does not have, are named") {
  const FakeCamera camera = fake_camera("127.0.0.1", "H-42");
  {
    const auto grabber = open_grabber(settings("gev:H-42"));
    CHECK(grab(*grabber, 1).front().serial == "H-42");
  }
  CHECK_THAT(problem_of(settings("gev:none")), Catch::Contains("none"));
  auto wrong = settings("gev:H-42");
  wrong.camera.features = {{"NoSuchFeature", "1"}};
  CHECK_THAT(problem_of(wrong), Catch::Contains("NoSuchFeature"));
}

TEST_CASE("features hold beside a trigger: of a camera that has the falling edge, too") {
  const horopter::TemporaryDirectory directory;
  std::string features;
  {
    const FakeCamera camera = fake_camera("127.0.0.1", "T1");
    std::size_t length = 0;
    const char* text = arv_fake_camera_get_genicam_xml(arv_gv_fake_camera_get_fake_camera(camera.get()), &length);
    features.assign(text, length);
  }
  const std::string edge = R"(<EnumEntry Name="RisingEdge" NameSpace="Standard">)";
  REQUIRE(features.find(edge) != std::string::npos);
  features.insert(features.find(edge),
                  R"(<EnumEntry Name="FallingEdge" NameSpace="Standard"><Value>1</Value></EnumEntry>)");
  const auto file = directory.write("features.xml", features);
  const FakeCamera camera(arv_gv_fake_camera_new_full("127.0.0.1", "T1", file.c_str()));
  REQUIRE(arv_gv_fake_camera_is_running(camera.get()));
  auto triggered = settings("gev:127.0.0.1");
  triggered.camera.trigger = "Line0";
  triggered.camera.features = {{"TriggerActivation", "FallingEdge"}};
  const auto grabber = open_grabber(triggered);
  const auto value_at = [&](guint64 address) {
    guint32 value = 0;
    REQUIRE(arv_fake_camera_read_register(arv_gv_fake_camera_get_fake_camera(camera.get()), address, &value));
    return value;
  };
  CHECK(value_at(ARV_FAKE_CAMERA_REGISTER_TRIGGER_MODE) == 1);
  CHECK(value_at(ARV_FAKE_CAMERA_REGISTER_TRIGGER_ACTIVATION) == 1);
}

TEST_CASE("a GigE Vision camera that is killed is lost, and comes back by itself") {
  std::optional<FakeCamera> camera(fake_camera("127.0.0.1", "K1"));
  Sink sink;
  const auto thread = start_camera(Side::left, Layout::single, settings("gev:127.0.0.1"), sink);
  REQUIRE(sink.wait([](Sink& s) { return s.frames_[Side::left].size() >= 2; }));
  camera.reset();
  REQUIRE(sink.wait([](Sink& s) { return !s.lost_.empty(); }));
  INFO(sink.lost_);
  camera.emplace(fake_camera("127.0.0.1", "K1"));
  REQUIRE(sink.wait([](Sink& s) { return s.connected_ == 2; }));
  const std::size_t before = sink.frames_[Side::left].size();
  CHECK(sink.wait([&](Sink& s) { return s.frames_[Side::left].size() > before + 2; }));
}

TEST_CASE("a GigE Vision camera that is not ours any more is lost, though it streams on") {
  const FakeCamera camera = fake_camera("127.0.0.1", "C1");
  const auto grabber = open_grabber(settings("gev:127.0.0.1"));
  grab(*grabber, 2);
  // Neither control nor exclusive access, and not free, with which it would stream no more.
  constexpr guint64 kPrivilege = 0xA00;  // the register of GigE Vision
  constexpr guint32 kOther = 4;
  REQUIRE(arv_fake_camera_write_register(arv_gv_fake_camera_get_fake_camera(camera.get()), kPrivilege, kOther));
  bool is_lost = false;
  const auto give_up = Clock::now() + 20s;  // Aravis looks each second
  while (!is_lost && Clock::now() < give_up) {
    try {
      const bool came = grabber->next(5s).has_value();
      CHECK(came);
    } catch (const CameraError& error) {
      CHECK_THAT(error.what(), Catch::Contains("is not ours any more"));
      is_lost = true;
    }
  }
  CHECK(is_lost);
}

TEST_CASE("a live pipeline of GStreamer: times by one clock, grey, and errors in its words") {
  const std::string live = "gst:videotestsrc is-live=true ! video/x-raw,width=64,height=32,framerate=20/1";
  const auto left = open_grabber(settings(live));
  const auto right = open_grabber(settings(live));
  const auto frames = grab(*left, 5);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto step = frames[i].taken - frames[i - 1].taken;
    CHECK(step > 0ns);
    CHECK(step % 50ms < 1ms);  // a busy computer leaves some out
  }
  CHECK(frames.front().image.width == 64);
  CHECK(frames.front().image.height == 32);
  // Both since the start of the first: the other one's time is close to ours.
  const auto other_frame = grab(*right, 1).front();
  CHECK(std::chrono::abs(other_frame.taken - other_frame.arrived.time_since_epoch()) < 30s);
  CHECK_THAT(problem_of(settings("gst:nosuchelement")), Catch::Contains("nosuchelement"));
  CHECK_THAT(problem_of(settings("gst:filesrc location=/none ! jpegdec")), Catch::Contains("GStreamer"));
  CHECK_FALSE(problem_of(settings("v4l2:/dev/video99")).empty());
}

TEST_CASE("a camera of this computer is asked for its rate as a fraction") {
  const auto rate = [](double frames_per_s) {
    const std::string text = v4l2_pipeline("/dev/video0", frames_per_s);
    const auto begin = text.find("video/x-raw,framerate=") + 22, end = text.find(';');
    const std::string fraction = text.substr(begin, end - begin);
    CHECK_THAT(text, Catch::Contains("v4l2src device=/dev/video0 ") &&
                         Catch::Contains(";image/jpeg,framerate=" + fraction + " ! decodebin"));
    return fraction;
  };
  CHECK(rate(30) == "30/1");
  CHECK(rate(1) == "1/1");
  CHECK(rate(7.5) == "15/2");
  CHECK(rate(12.5) == "25/2");
  CHECK(rate(29.97) == "30000/1001");
  CHECK(rate(59.94) == "60000/1001");
  CHECK(rate(23.976) == "24000/1001");
}

TEST_CASE("of JPEG images those that are not whole are lost parts, and no images") {
  const std::string data = "/usr/share/doc/opencv-doc/examples/data/";
  const horopter::TemporaryDirectory directory;
  const std::string decoder = GENERATE("jpegdec", "decodebin");
  CAPTURE(decoder);
  for (int i = 0; i < 6; ++i) {
    auto bytes = horopter::bytes_of(data + "left0" + std::to_string(i + 1) + ".jpg");
    if (i == 2 || i == 5) bytes.resize(bytes.size() * 8 / 10);
    if (i == 3) bytes.erase(bytes.end() - 4000, bytes.end() - 1000);
    directory.write(std::to_string(i) + ".jpg", bytes);
  }
  const auto grabber = open_grabber(settings("gst:multifilesrc location=" + directory.path().string() +
                                             "/%d.jpg stop-index=5 caps=image/jpeg,framerate=10/1 ! " + decoder));
  std::vector<CameraFrame> whole;
  std::uint64_t lost = 0;
  std::string end;
  for (const auto give_up = Clock::now() + 60s; end.empty() && Clock::now() < give_up;) {
    try {
      auto frame = grabber->next(100ms);
      if (!frame) continue;
      if (frame->image.empty()) CHECK(frame->lost_packets > lost);
      lost = frame->lost_packets;
      if (!frame->image.empty()) whole.push_back(std::move(*frame));
    } catch (const CameraError& error) {
      end = error.what();
    }
  }
  CHECK_THAT(end, Catch::Contains("the stream has ended"));
  CHECK(whole.size() == 3);
  CHECK(lost == 3);
}

TEST_CASE("of images that are told by those before them none counts behind a gap, up to the next that stands alone") {
  const std::string begin =
      "gst:videotestsrc pattern=ball num-buffers=200 ! video/x-raw,format=I420,width=96,height=64,framerate=100/1 ! "
      "vp8enc deadline=1 cpu-used=-4 keyframe-max-dist=8 ";  // a speed that does not follow the computer's
  const Seen whole = see(begin + "! vp8dec");
  CHECK(whole.lost == 0);
  REQUIRE(whole.images.size() > 100);
  for (const std::string gaps :
       {"! identity drop-probability=0.1 ", "! rtpvp8pay mtu=100 ! identity drop-probability=0.05 ! rtpvp8depay "}) {
    CAPTURE(gaps);
    const Seen seen = see(begin + gaps + "! vp8dec");
    CHECK(seen.lost > 0);
    CHECK(seen.images.size() > 10);
    CHECK(std::ranges::includes(whole.images, seen.images));  // nothing was made up
  }
}

TEST_CASE("an image behind which a gap was noticed may have the hole, although it stands alone, and so may the next") {
  const PacketMarks key{}, delta{.difference = true}, key_at_gap{.gap = true},
      delta_at_gap{.gap = true, .difference = true};
  const PacketMarks head{.gap = true, .difference = true, .head = true}, damaged{.damaged = true};
  const auto counted = [](const std::vector<PacketMarks>& all) {
    Succession succession;
    std::string text;
    for (const PacketMarks& marks : all) text += succession.counts(marks) ? '+' : '-';
    return text;
  };
  CHECK(counted({key, delta, key_at_gap, delta, key_at_gap, delta, key}) == "++----+");
  CHECK(counted({key_at_gap, delta, key, delta}) == "++++");            // every stream begins with a gap
  CHECK(counted({delta, delta_at_gap, delta, key, delta}) == "---++");  // or in the middle
  CHECK(counted({head, head, key_at_gap, delta, delta_at_gap, key, key}) == "++++--+");  // of Theora
  CHECK(counted({key, damaged, delta, key, delta}) == "+--++");
  CHECK(counted({key, delta, delta_at_gap, delta, key, delta}) == "++--++");
  // All stand alone: two are lost with each gap, for nobody knows whether they are whole.
  CHECK(counted({key_at_gap, key, key_at_gap, key, key, key_at_gap, key_at_gap, key, key}) == "++--+---+");
}

TEST_CASE("of raw images from the network none counts of which a packet was lost") {
  const std::string begin =
      "gst:videotestsrc pattern=ball num-buffers=200 ! video/x-raw,format=I420,width=96,height=64,framerate=100/1 ! ";
  const Seen whole = see(begin + "identity");
  CHECK(see(begin + "rtpvrawpay mtu=1000 ! rtpvrawdepay").lost == 0);
  Seen seen = see(begin + "rtpvrawpay mtu=1000 ! identity drop-probability=0.02 ! rtpvrawdepay");
  seen.images.erase(seen.first);  // every stream begins with a gap, which hides one in its first image
  CHECK(seen.lost > 0);
  CHECK(seen.images.size() > 10);
  CHECK(std::ranges::includes(whole.images, seen.images));
}

TEST_CASE("streams of which nothing is lost are whole, whatever their encoders say of differences") {
  const std::string encoders =
      GENERATE("pngenc ! pngdec", "theoraenc ! oggmux ! oggdemux ! theoradec", "jpegenc ! jpegdec");
  CAPTURE(encoders);
  const auto grabber = open_grabber(settings(
      "gst:videotestsrc num-buffers=20 ! video/x-raw,format=I420,width=64,height=48,framerate=50/1 ! videoconvert ! " +
      encoders));
  int images = 0;
  try {
    for (const auto give_up = Clock::now() + 60s; Clock::now() < give_up;) {
      const auto frame = grabber->next(100ms);
      if (!frame) continue;
      CHECK(frame->lost_packets == 0);
      images += frame->image.empty() ? 0 : 1;
    }
  } catch (const CameraError& error) {
    CHECK_THAT(error.what(), Catch::Contains("the stream has ended"));
  }
  CHECK(images == 20);
}

TEST_CASE("what a video lost when it was recorded is lost when it is shown") {
  const horopter::TemporaryDirectory directory;
  const auto path = directory / "hole.mkv";
  {
    cv::VideoWriter video(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 50, {64, 48});
    REQUIRE(video.isOpened());
    for (int i = 0; i < 4; ++i) video.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(50 * i)));
  }
  auto bytes = horopter::bytes_of(path);
  horopter::delay_images(bytes, 2, 4, 40);
  directory.write("hole.mkv", bytes);
  const auto grabber = open_grabber(settings_of_all("files:" + path.string(), 50));
  std::vector<std::uint64_t> numbers;
  for (const auto& frame : grab(*grabber, 4)) numbers.push_back(frame.number.value());
  CHECK(numbers[1] == numbers[0] + 1);
  CHECK(numbers[2] == numbers[0] + 4);
  CHECK(numbers[3] == numbers[0] + 5);
}

TEST_CASE("files that are opened late, or again, show the image of the moment, as those of the other camera") {
  const horopter::TemporaryDirectory directory;
  constexpr int kImages = 5;
  for (int i = 0; i < kImages; ++i) {
    const std::string grey = std::to_string(40 * i);
    directory.write("i" + std::to_string(i) + ".pgm", "P2 2 1 255 " + grey + " " + grey + "\n");
  }
  auto late = settings("files:" + directory.path().string(), 50);
  late.camera.repeat = true;
  for (const Clock::duration since : {Clock::duration(200ms), Clock::duration(1h)}) {
    late.begin = Clock::now() - since;
    const auto grabber = open_grabber(late);
    const auto frames = grab(*grabber, 2 * kImages + 1);
    CHECK(frames.front().taken >= (late.begin + since).time_since_epoch());
    for (const CameraFrame& frame : frames) {
      CHECK(frame.image.at(0, 0) == 40 * (frame.number.value() % kImages));
      CHECK(frame.taken == (late.begin + frame.number.value() * 20ms).time_since_epoch());
    }
  }
  late.camera.repeat = false;
  late.frames_per_s = 1;
  late.begin = Clock::now() - 1200ms;
  const auto grabber = open_grabber(late);
  const auto frame = grab(*grabber, 1).front();
  CHECK(frame.number.value() >= 2);
  CHECK(frame.image.at(0, 0) == 40 * frame.number.value());
  late.begin = Clock::now() - 1h;
  const auto over = open_grabber(late);
  CHECK_FALSE(over->next(10s));
  CHECK(over->ended());
}

TEST_CASE("files of which one cannot be read go on behind it when they are opened again, each under its number") {
  const horopter::TemporaryDirectory directory;
  constexpr std::uint64_t kImages = 5, kDamaged = 1;
  for (std::uint64_t i = 0; i < kImages; ++i) {
    const std::string grey = std::to_string(40 * i);
    directory.write("i" + std::to_string(i) + ".pgm", "P2 2 1 255 " + grey + (i == kDamaged ? "" : " " + grey) + "\n");
  }
  auto late = settings("files:" + directory.path().string(), 50);
  late.camera.repeat = true;
  late.begin = Clock::now() - 1h;
  std::vector<CameraFrame> frames;
  for (const auto give_up = Clock::now() + 60s; frames.size() < 3 * kImages && Clock::now() < give_up;) {
    try {
      for (const auto grabber = open_grabber(late); frames.size() < 3 * kImages && Clock::now() < give_up;) {
        if (auto frame = grabber->next(100ms)) frames.push_back(std::move(*frame));
      }
    } catch (const horopter::FileError& error) {  // in time the damaged one is told
      CHECK_THAT(error.what(), Catch::Contains("i1.pgm"));
    }
  }
  REQUIRE(frames.size() == 3 * kImages);
  for (const CameraFrame& frame : frames) {
    const std::uint64_t number = frame.number.value();
    CHECK(number % kImages != kDamaged);
    CHECK(frame.image.at(0, 0) == 40 * (number % kImages));
    CHECK(frame.taken == (late.begin + number * 20ms).time_since_epoch());
  }
  for (std::uint64_t i = 0; i < kImages; ++i) directory.write("i" + std::to_string(i) + ".pgm", "P2 2 1 255 7\n");
  late.camera.repeat = false;
  CHECK_FALSE(open_grabber(late)->next(10s));  // all of them are over
}

TEST_CASE("an image that is shorter than its size is lost; JPEG in pieces is an error") {
  const auto grabber = open_grabber(
      settings("gst:fakesrc is-live=true sizetype=fixed sizemax=100 filltype=zero format=time datarate=1000 ! "
               "video/x-raw,format=GRAY8,width=64,height=32,framerate=10/1"));
  std::optional<CameraFrame> frame;
  for (const auto give_up = Clock::now() + 60s; !frame && Clock::now() < give_up;) frame = grabber->next(100ms);
  REQUIRE(frame);
  CHECK(frame->image.empty());
  CHECK(frame->lost_packets == 1);
  CHECK_THAT(problem_of(settings("gst:filesrc location=/usr/share/doc/opencv-doc/examples/data/left01.jpg ! jpegdec")),
             Catch::Contains("in pieces"));
}

TEST_CASE("images without times are an error: nobody knows how old they are") {
  const std::string caps = " ! video/x-raw,format=GRAY8,width=64,height=32,framerate=10/1";
  const std::string source = "gst:fakesrc sizetype=fixed sizemax=2048 filltype=zero format=time";
  Sink sink;
  const auto thread = start_camera(Side::left, Layout::single, settings(source + caps), sink);
  REQUIRE(sink.wait([](Sink& s) { return !s.lost_.empty() || !s.frames_[Side::left].empty(); }));
  CHECK_THAT(sink.lost_, Catch::Contains("its images have no times"));
  const auto timed = open_grabber(settings(source + " is-live=true do-timestamp=true datarate=20480" + caps));
  CHECK(grab(*timed, 2).back().taken_here);
}

TEST_CASE("both images side by side in one are two") {
  Sink sink;
  const auto thread = start_camera(
      Side::left, Layout::side_by_side,
      settings("gst:videotestsrc is-live=true pattern=smpte ! video/x-raw,width=64,height=32,framerate=20/1"), sink);
  REQUIRE(sink.wait([](Sink& s) { return !s.frames_[Side::left].empty() && !s.frames_[Side::right].empty(); }));
  const auto &left = sink.frames_[Side::left].front(), &right = sink.frames_[Side::right].front();
  CHECK(left.image.width == 32);
  CHECK(right.image.width == 32);
  CHECK(left.taken == right.taken);
  CHECK(left.image.at(0, 0) > right.image.at(31, 0));  // the bars fall from grey to blue
}

TEST_CASE("files end, or begin again; a pattern without files is lost with its name") {
  const std::string data = "/usr/share/doc/opencv-doc/examples/data/";
  auto some = settings_of_all("files:" + data + "left0[12].jpg", 100);
  auto grabber = open_grabber(some);
  CHECK(grab(*grabber, 2).size() == 2);
  CHECK_FALSE(grabber->next(100ms));
  CHECK(grabber->ended());
  some.camera.repeat = true;
  grabber = open_grabber(some);
  const auto frames = grab(*grabber, 5);
  CHECK(frames[0].image == frames[2].image);
  CHECK(frames[4].taken - frames[0].taken == 40ms);
  CHECK_FALSE(grabber->ended());
  Sink sink;
  const auto thread = start_camera(Side::right, Layout::single, settings("files:/none*.png"), sink);
  REQUIRE(sink.wait([](Sink& s) { return !s.lost_.empty(); }));
  CHECK_THAT(sink.lost_, Catch::Contains("/none*.png"));
}
