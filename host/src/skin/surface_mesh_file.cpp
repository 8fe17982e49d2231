// SPDX-License-Identifier: Apache-2.0
// Meshes from files. Strictly: a file that was cut or damaged must not become a smaller skin. (Assimp 5.2 takes what it
// finds of a file that was cut, and hangs or aborts on some.)
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/skin/surface.hpp"

namespace horopter {
namespace {

using Eigen::Vector3d;

/// A mesh as a file tells it; vertices at the same place become one, polygons become triangles.
class Builder {
 public:
  Builder(std::string file, double unit_mm) : file_(std::move(file)), unit_mm_(unit_mm) {}

  [[noreturn]] void fail(const std::string& place, const std::string& found, const std::string& expected) const {
    throw FileError(file_, place, found, expected);
  }

  void add_vertex(const std::string& place, const std::array<double, 3>& at) {
    for (const double value : at) {
      if (!std::isfinite(value)) fail(place, "a coordinate that is not finite", "numbers");
    }
    // + 0 makes −0 and 0 one place.
    const auto [found, is_new] = places_.try_emplace({at[0] + 0.0, at[1] + 0.0, at[2] + 0.0},
                                                     static_cast<std::uint32_t>(mesh_.vertices_mm.size()));
    if (is_new) mesh_.vertices_mm.emplace_back(unit_mm_ * Vector3d(at[0], at[1], at[2]));
    index_.push_back(found->second);
  }
  std::size_t vertices() const { return index_.size(); }

  /// A convex polygon of vertices in the order in which they were added, from 0.
  void add_face(const std::string& place, std::span<const std::int64_t> corners) {
    if (corners.size() < 3) fail(place, fmt::format("{} corners", corners.size()), "3 or more");
    std::vector<std::uint32_t> polygon;
    for (const std::int64_t corner : corners) {
      if (corner < 0 || corner >= static_cast<std::int64_t>(index_.size())) {
        fail(place, fmt::format("vertex {}", corner), fmt::format("one of the {} vertices before it", index_.size()));
      }
      polygon.push_back(index_[static_cast<std::size_t>(corner)]);
    }
    const auto at = [&](std::size_t i) -> const Vector3d& { return mesh_.vertices_mm[polygon[i % polygon.size()]]; };
    Vector3d normal = Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) normal += (at(i) - at(0)).cross(at(i + 1) - at(0));
    const double area = normal.squaredNorm();
    for (std::size_t i = 0; polygon.size() > 3 && i < polygon.size(); ++i) {
      const double turn = normal.dot((at(i + 1) - at(i)).cross(at(i + 2) - at(i + 1)));
      if (!(area > 0) || turn < -1e-6 * area) {
        fail(place, "a polygon that is not convex", "triangles, or convex polygons");
      }
    }
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      mesh_.triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
    }
  }

  TriangleMesh take() { return std::move(mesh_); }

 private:
  std::string file_;
  double unit_mm_;
  TriangleMesh mesh_;
  std::map<std::array<double, 3>, std::uint32_t> places_;  // STL repeats each vertex in each triangle
  std::vector<std::uint32_t> index_;                       // of vertices as they were added
};

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Words of a text, with the line that they stand in.
class Words {
 public:
  Words(std::string_view text, int line) : text_(text), line_(line) {}

  /// Empty at the end.
  std::string_view next() {
    while (!text_.empty() && is_space(text_.front())) {
      line_ += text_.front() == '\n' ? 1 : 0;
      text_.remove_prefix(1);
    }
    const auto end = std::ranges::find_if(text_, is_space);
    const auto length = static_cast<std::size_t>(end - text_.begin());
    const std::string_view word = text_.substr(0, length);
    text_.remove_prefix(length);
    return word;
  }
  void skip_line() {
    const auto end = text_.find_first_of("\r\n");
    text_.remove_prefix(std::min(end, text_.size()));
  }
  std::string place() const { return fmt::format("line {}", line_); }

 private:
  std::string_view text_;
  int line_;
};

template <class T>
std::optional<T> parse(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string quoted(std::string_view word) {
  return word.empty() ? "the end of the file" : fmt::format("'{}'", word.substr(0, 40));
}

double number(const Builder& builder, Words& words, const char* expected) {
  const std::string_view word = words.next();
  const auto value = parse<double>(word);
  if (!value) builder.fail(words.place(), quoted(word), expected);
  return *value;
}

std::array<double, 3> numbers(const Builder& builder, Words& words, const char* expected) {
  std::array<double, 3> values{};
  for (double& value : values) value = number(builder, words, expected);
  return values;
}

// --- OBJ -------------------------------------------------------------------------------------------------------------

/// Whether lines of this key hold no face, and no vertex of one. Any other may be one that was damaged.
bool is_beside_faces(std::string_view key) {
  constexpr std::string_view kBeside[] = {"vt",       "vn",       "vp",         "g",      "o",        "s",   "mg",
                                          "l",        "p",        "usemtl",     "mtllib", "usemap",   "lod", "bevel",
                                          "c_interp", "d_interp", "shadow_obj", "maplib", "trace_obj"};
  return key.empty() || key.starts_with('#') || std::ranges::find(kBeside, key) != std::end(kBeside);
}

void read_obj(std::string_view text, Builder& builder) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  int line_number = 0;
  while (!text.empty()) {
    ++line_number;
    const auto end = text.find('\n');
    Words words(text.substr(0, end), line_number);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    const std::string_view key = words.next();
    if (end == text.npos && (key == "v" || key == "f")) {
      builder.fail(words.place(), "the end of the file within a line", "a line that ends: the file may have been cut");
    }
    if (key == "v") {
      builder.add_vertex(words.place(), numbers(builder, words, "v x y z"));
    } else if (key == "f") {
      std::vector<std::int64_t> corners;
      for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        const auto index = parse<std::int64_t>(word.substr(0, word.find('/')));
        if (!index || *index == 0) builder.fail(words.place(), quoted(word), "f with the numbers of vertices, from 1");
        corners.push_back(*index > 0 ? *index - 1 : static_cast<std::int64_t>(builder.vertices()) + *index);
      }
      builder.add_face(words.place(), corners);
    } else if (!is_beside_faces(key)) {
      builder.fail(words.place(), quoted(key), "v, f, or what holds no face; free-form surfaces as triangles");
    }
  }
}

// --- STL -------------------------------------------------------------------------------------------------------------

constexpr std::size_t kStlHeader = 84;
constexpr std::size_t kStlFacet = 50;

template <class T>
T little_endian(std::string_view bytes) {
  std::array<char, sizeof(T)> raw{};
  std::ranges::copy(bytes.substr(0, sizeof(T)), raw.begin());
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  return std::bit_cast<T>(raw);
}

void read_stl_binary(std::string_view bytes, Builder& builder) {
  if (bytes.size() < kStlHeader) {
    builder.fail("header", fmt::format("{} bytes", bytes.size()), "84 bytes, or `solid`");
  }
  const std::size_t facets = little_endian<std::uint32_t>(bytes.substr(80));
  if (bytes.size() != kStlHeader + kStlFacet * facets) {
    builder.fail("header", fmt::format("{} facets in {} bytes", facets, bytes.size()),
                 fmt::format("{} bytes", kStlHeader + kStlFacet * facets));
  }
  for (std::size_t facet = 0; facet < facets; ++facet) {
    const std::string place = fmt::format("facet {}", facet);
    const auto first = static_cast<std::int64_t>(builder.vertices());
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<double, 3> at{};
      for (std::size_t i = 0; i < 3; ++i) {
        at[i] = little_endian<float>(bytes.substr(kStlHeader + kStlFacet * facet + 12 * (corner + 1) + 4 * i));
      }
      builder.add_vertex(place, at);
    }
    builder.add_face(place, std::array{first, first + 1, first + 2});
  }
}

void read_stl_text(std::string_view text, Builder& builder) {
  Words words(text, 1);
  const auto expect = [&](std::string_view expected) {
    const std::string_view word = words.next();
    if (word != expected) builder.fail(words.place(), quoted(word), std::string(expected));
  };
  const auto read_facet = [&] {
    expect("normal");
    numbers(builder, words, "normal x y z");
    expect("outer");
    expect("loop");
    const auto first = static_cast<std::int64_t>(builder.vertices());
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      const auto at = numbers(builder, words, "vertex x y z");
      builder.add_vertex(words.place(), at);
    }
    expect("endloop");
    expect("endfacet");
    builder.add_face(words.place(), std::array{first, first + 1, first + 2});
  };
  std::string_view word = words.next();
  do {
    if (word != "solid") builder.fail(words.place(), quoted(word), "solid, or the end of the file");
    words.skip_line();
    for (word = words.next(); word != "endsolid"; word = words.next()) {
      if (word != "facet") builder.fail(words.place(), quoted(word), "facet or endsolid");
      read_facet();
    }
    words.skip_line();
    word = words.next();
  } while (!word.empty());
  if (builder.vertices() == 0) builder.fail(words.place(), "no facet", "one or more");
}

// --- PLY -------------------------------------------------------------------------------------------------------------

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
constexpr std::size_t kPlySize[] = {1, 1, 2, 2, 4, 4, 4, 8};

std::optional<PlyType> ply_type(std::string_view name) {
  static const std::map<std::string_view, PlyType> types{
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  const auto found = types.find(name);
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count;  ///< of a list
};
bool holds_corners(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};
enum class PlyFormat { ascii, little, big };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;
  int lines = 0;
};

PlyHeader read_ply_header(std::string_view text, const Builder& builder) {
  PlyHeader header;
  bool has_format = false;
  for (;;) {
    const auto end = text.find('\n', header.bytes);
    const std::string place = fmt::format("line {}", ++header.lines);
    if (end == text.npos) builder.fail(place, "the end of the file", "end_header");
    Words words(text.substr(header.bytes, end - header.bytes), header.lines);
    header.bytes = end + 1;
    const std::string_view key = words.next();
    if (header.lines == 1) {
      if (key != "ply") builder.fail(place, quoted(key), "ply");
    } else if (key == "end_header") {
      break;
    } else if (key == "format") {
      const std::string_view format = words.next();
      if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian") {
        builder.fail(place, quoted(format), "ascii, binary_little_endian or binary_big_endian");
      }
      header.format = format == "ascii"                  ? PlyFormat::ascii
                      : format == "binary_little_endian" ? PlyFormat::little
                                                         : PlyFormat::big;
      has_format = true;
    } else if (key == "element") {
      const std::string name(words.next());
      const std::string_view word = words.next();
      const auto count = parse<std::uint32_t>(word);
      if (!count) builder.fail(place, quoted(word), "element with a name and a number");
      header.elements.push_back({name, *count, {}});
    } else if (key == "property") {
      if (header.elements.empty()) builder.fail(place, "a property of nothing", "element");
      PlyProperty property;
      std::string_view type = words.next();
      if (type == "list") {
        property.count = ply_type(words.next());
        if (!property.count) builder.fail(place, "a list without a type of its length", "property list uchar int …");
        type = words.next();
      }
      const auto known = ply_type(type);
      if (!known) builder.fail(place, quoted(type), "char, uchar, short, ushort, int, uint, float or double");
      property.type = *known;
      property.name = words.next();
      header.elements.back().properties.push_back(property);
    } else if (key != "comment" && key != "obj_info" && !key.empty()) {
      builder.fail(place, quoted(key), "format, element, property, comment or end_header");
    }
  }
  if (!has_format) builder.fail("header", "no format", "format ascii 1.0, or a binary one");
  return header;
}

/// Values of a PLY's body, one after the other.
class PlyValues {
 public:
  PlyValues(std::string_view bytes, const PlyHeader& header)
      : format_(header.format), bytes_(bytes), words_(bytes, header.lines + 1) {}

  /// Nothing where there is none.
  std::optional<double> next(PlyType type) {
    if (format_ == PlyFormat::ascii) return parse<double>(words_.next());
    const std::size_t size = kPlySize[static_cast<std::size_t>(type)];
    if (bytes_.size() < size) return std::nullopt;
    std::array<char, 8> raw{};
    std::ranges::copy(bytes_.substr(0, size), raw.begin());
    bytes_.remove_prefix(size);
    if (format_ == PlyFormat::big) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    const std::string_view value(raw.data(), raw.size());
    switch (type) {
      case PlyType::int8:
        return little_endian<std::int8_t>(value);
      case PlyType::uint8:
        return little_endian<std::uint8_t>(value);
      case PlyType::int16:
        return little_endian<std::int16_t>(value);
      case PlyType::uint16:
        return little_endian<std::uint16_t>(value);
      case PlyType::int32:
        return little_endian<std::int32_t>(value);
      case PlyType::uint32:
        return little_endian<std::uint32_t>(value);
      case PlyType::float32:
        return little_endian<float>(value);
      case PlyType::float64:
        return little_endian<double>(value);
    }
    return std::nullopt;
  }
  bool at_end() { return format_ == PlyFormat::ascii ? words_.next().empty() : bytes_.empty(); }
  /// In words of the file.
  std::string place(const PlyElement& element, std::size_t row) const {
    return format_ == PlyFormat::ascii ? words_.place() : fmt::format("{} {}", element.name, row);
  }

 private:
  PlyFormat format_;
  std::string_view bytes_;
  Words words_;
};

void read_ply_row(const PlyElement& element, std::size_t row, PlyValues& values, Builder& builder) {
  const auto value = [&](PlyType type, const std::string& name) {
    const auto found = values.next(type);
    if (!found) {
      builder.fail(values.place(element, row), "the file ends, or is damaged",
                   fmt::format("{} of {} {} of {}", name, element.name, row, element.count));
    }
    return *found;
  };
  std::array<double, 3> at{};
  std::vector<std::int64_t> corners;
  for (const PlyProperty& property : element.properties) {
    if (!property.count) {
      const double number = value(property.type, property.name);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (property.name == std::string(1, static_cast<char>('x' + axis))) at[axis] = number;
      }
      continue;
    }
    const double count = value(*property.count, property.name);
    if (!(count >= 0 && count <= 1e6 && count == std::trunc(count))) {
      builder.fail(values.place(element, row), fmt::format("a list of {} values", count), "a length");
    }
    const bool is_corners = holds_corners(property);
    for (double i = 0; i < count; ++i) {
      const double number = value(property.type, property.name);
      if (!is_corners) continue;
      if (!(std::abs(number) < 1e15 && number == std::trunc(number))) {
        builder.fail(values.place(element, row), fmt::format("vertex {}", number), "the number of a vertex, from 0");
      }
      corners.push_back(static_cast<std::int64_t>(number));
    }
  }
  if (element.name == "vertex") builder.add_vertex(values.place(element, row), at);
  if (element.name == "face") builder.add_face(values.place(element, row), corners);
}

void read_ply(std::string_view bytes, Builder& builder) {
  const PlyHeader header = read_ply_header(bytes, builder);
  const auto need = [&](const char* name, std::initializer_list<std::string_view> properties) {
    const auto element = std::ranges::find(header.elements, name, &PlyElement::name);
    const bool complete =
        element != header.elements.end() && std::ranges::all_of(properties, [&](std::string_view wanted) {
          return std::ranges::any_of(element->properties, [&](const PlyProperty& p) {
            return p.name == wanted || (wanted == "vertex_indices" && holds_corners(p));
          });
        });
    if (!complete)
      builder.fail("header", fmt::format("no element {} that is complete", name), "x, y, z; vertex_indices");
  };
  need("vertex", {"x", "y", "z"});
  need("face", {"vertex_indices"});
  for (const PlyElement& element : header.elements) {
    const auto same = std::ranges::count(header.elements, element.name, &PlyElement::name);
    if (same > 1) builder.fail("header", fmt::format("{} elements {}", same, element.name), "one");
    // Rows of nothing would not end where the file does.
    if (element.properties.empty()) builder.fail("header", "an element " + element.name + " of nothing", "property");
    if (element.name != "face" && element.count > 0 && std::ranges::any_of(element.properties, holds_corners)) {
      builder.fail("header", fmt::format("{} {}, which hold faces", element.count, element.name),
                   "all faces in the element face");
    }
  }
  PlyValues values(bytes.substr(header.bytes), header);
  for (const PlyElement& element : header.elements) {
    for (std::size_t row = 0; row < element.count; ++row) read_ply_row(element, row, values, builder);
  }
  if (!values.at_end()) builder.fail("end", "more than the header announces", "the end of the file");
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path, double unit_mm) {
  const std::string expected = "a mesh (PLY, STL or OBJ)";
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  if (extension != ".ply" && extension != ".stl" && extension != ".obj") {
    throw FileError(path.string(), "", "a file named '" + extension + "'", expected);
  }
  const auto raw = read_file(path, expected);
  const std::string_view bytes(reinterpret_cast<const char*>(raw.data()), raw.size());
  Builder builder(path.string(), unit_mm);
  if (extension == ".obj") {
    read_obj(bytes, builder);
  } else if (extension == ".ply") {
    read_ply(bytes, builder);
  } else if (bytes.starts_with("solid") &&
             !(bytes.size() >= kStlHeader &&
               bytes.size() == kStlHeader + kStlFacet * little_endian<std::uint32_t>(bytes.substr(80)))) {
    read_stl_text(bytes, builder);
  } else {
    read_stl_binary(bytes, builder);
  }
  return builder.take();
}

}  // namespace horopter
