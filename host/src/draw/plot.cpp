// SPDX-License-Identifier: Apache-2.0
#include "horopter/draw/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "horopter/base/xml.hpp"

namespace horopter {
namespace {

constexpr std::array kColours{"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd", "#8c564b",
                              "#e377c2", "#17becf", "#7f7f7f", "#bcbd22", "#000000", "#3b3b98"};

struct Range {
  double low = 1e300;
  double high = -1e300;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// By `by` where it is narrower than `least`.
  void widen(double least, double by) {
    if (high - low >= least) return;
    low -= by / 2;
    high += by / 2;
  }
};

constexpr double kMarginLeft = 58;  ///< px about a panel's axes
constexpr double kMarginRight = 14;
constexpr double kMarginTop = 24;
constexpr double kMarginBottom = 40;

/// A panel's axes on the page, and where its values lie.
class Axes {
 public:
  Axes(const Panel& panel, double left, double top, double width, double height)
      : panel_(panel),
        left_(left + kMarginLeft),
        top_(top + kMarginTop),
        width_(width - kMarginLeft - kMarginRight),
        height_(height - kMarginTop - kMarginBottom) {
    for (const Curve& curve : panel.curves)
      for (const auto& [x, y] : curve.points) {
        if (!std::isfinite(y)) continue;
        x_.add(x);
        y_.add(scaled(y));
      }
    if (empty()) return;
    x_.widen(1e-12, 1);
    y_.widen(1e-9, 1e-3);
    const double margin = 0.05 * (y_.high - y_.low);
    y_.low -= margin;
    y_.high += margin;
  }
  /// Without a value to show.
  bool empty() const { return x_.low > x_.high; }

  /// Frame, ticks, title and labels.
  std::string drawn() const {
    const double middle = left_ + width_ / 2;
    std::string svg = text(middle, top_ - 9, "middle", 12, panel_.title, " font-weight=\"bold\"");
    for (const double x : ticks(x_.low, x_.high, 5))
      svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#ddd\"/>", px(x), top_, top_ + height_) +
             text(px(x), top_ + height_ + 12, "middle", 10, fmt::format("{:g}", x));
    if (panel_.log_y) {
      svg += log_ticks();
    } else {
      for (const double y : ticks(y_.low, y_.high, 5)) svg += y_tick(y, y);
    }
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
        "stroke=\"black\"/>\n",
        left_, top_, width_, height_);
    svg += text(middle, top_ + height_ + 28, "middle", 11, panel_.x_label);
    const std::string y_label = panel_.y_label + (panel_.log_y ? ", log scale" : "");
    const double fitting =
        (height_ + kMarginBottom) / (0.56 * static_cast<double>(std::max<std::size_t>(1, y_label.size())));
    const int size = static_cast<int>(std::clamp(fitting, 7.0, 11.0));
    return svg + fmt::format("<g transform=\"translate({:.1f} {:.1f}) rotate(-90)\">{}</g>\n", left_ - 46,
                             top_ + height_ / 2, text(0, 0, "middle", size, y_label));
  }

  std::string drawn(const Curve& curve, const std::string& pen) const {
    std::string path;
    bool pen_down = false;
    for (const auto& [x, y] : curve.points) {
      if (std::isfinite(y)) path += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", px(x), py(scaled(y)));
      pen_down = std::isfinite(y);
    }
    return fmt::format("<path d=\"{}\" {} stroke-width=\"1.4\"><title>{}</title></path>\n", path, pen,
                       xml_text(curve.name));
  }

  static std::string text(double x, double y, const char* anchor, int size, const std::string& words,
                          const char* more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\"{}>{}</text>\n", x, y,
                       anchor, size, more, xml_text(words));
  }

 private:
  double scaled(double value) const { return panel_.log_y ? std::log10(std::max(value, 1e-6)) : value; }
  double px(double x) const { return left_ + (x - x_.low) / (x_.high - x_.low) * width_; }
  double py(double y) const { return top_ + (y_.high - y) / (y_.high - y_.low) * height_; }

  /// `at` on the axis, which says `value` there.
  std::string y_tick(double at, double value) const {
    return fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#ddd\"/>", left_, py(at), left_ + width_) +
           text(left_ - 4, py(at) + 3.5, "end", 10, fmt::format("{:g}", value));
  }
  /// Decades; 1, 2, 5 within a decade where there are few of them.
  std::string log_ticks() const {
    std::string svg;
    for (int power = static_cast<int>(std::floor(y_.low)); power <= y_.high; ++power)
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double at = power + std::log10(digit);
        if (at < y_.low || at > y_.high || (digit > 1 && y_.high - y_.low > 2)) continue;
        svg += y_tick(at, digit * std::pow(10.0, power));
      }
    return svg;
  }

  const Panel& panel_;
  double left_, top_, width_, height_;  ///< of the frame, px
  Range x_, y_;                         ///< y: its logarithm where the axis is logarithmic
};

/// One colour for each name; dashes once the colours are used up.
class CurveNames {
 public:
  explicit CurveNames(const std::vector<Panel>& panels) {
    for (const Panel& panel : panels)
      for (const Curve& curve : panel.curves)
        if (std::find(names_.begin(), names_.end(), curve.name) == names_.end()) names_.push_back(curve.name);
  }

  std::string pen(const std::string& name) const {
    const auto index = static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
    return fmt::format("fill=\"none\" stroke=\"{}\"{}", kColours[index % kColours.size()],
                       index < kColours.size() ? "" : " stroke-dasharray=\"5 3\"");
  }

  double height(double page_width) const {
    const std::size_t columns = columns_of(page_width);
    return kRow * static_cast<double>((names_.size() + columns - 1) / columns);
  }
  std::string drawn(double top, double page_width) const {
    const std::size_t columns = columns_of(page_width);
    std::string svg;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const double x = 12 + static_cast<double>(i % columns) * entry_width();
      const double y = top + 12 + kRow * static_cast<double>(i / columns);
      svg += fmt::format("<path d=\"M{:.1f} {:.1f}h18\" {} stroke-width=\"2\"/>", x, y - 4, pen(names_[i])) +
             Axes::text(x + 23, y, "start", 11, names_[i]);
    }
    return svg;
  }

 private:
  static constexpr double kRow = 16;  ///< px
  double entry_width() const {
    std::size_t longest = 1;
    for (const std::string& name : names_) longest = std::max(longest, name.size());
    return 30 + 6.5 * static_cast<double>(longest);
  }
  std::size_t columns_of(double page_width) const {
    return static_cast<std::size_t>(std::max(1.0, page_width / entry_width()));
  }

  std::vector<std::string> names_;
};

/// Lines of at most so many letters, broken between words.
std::vector<std::string> lines_of(const std::string& words, std::size_t letters) {
  std::vector<std::string> lines{""};
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    std::string& last = lines.back();
    if (last.empty()) {
      last = word;
    } else if (last.size() + 1 + word.size() <= letters) {
      last += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace

std::vector<double> ticks(double low, double high, int count) {
  const double rough = (high - low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (factor * power >= rough) {
      step = factor * power;
      break;
    }
  std::vector<double> result;
  for (double at = std::ceil(low / step - 1e-9) * step; at <= high + 1e-9 * step; at += step)
    result.push_back(std::abs(at) < 1e-9 * step ? 0 : at);
  return result;
}

std::string plot_svg(const std::string& title, const std::vector<Panel>& panels, int columns) {
  const bool alone = panels.size() == 1;
  const double width = alone ? 480 : 320;
  const double height = alone ? 330 : 235;
  columns = std::clamp(columns, 1, std::max(1, static_cast<int>(panels.size())));
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const double total_width = columns * width;
  const std::vector<std::string> title_lines = lines_of(title, static_cast<std::size_t>(total_width / 7.5));
  const double head = 12 + 18 * static_cast<double>(title_lines.size());
  const CurveNames legend(panels);
  const double total_height = head + rows * height + legend.height(total_width) + 10;

  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      total_width, total_height);
  for (std::size_t i = 0; i < title_lines.size(); ++i)
    svg += Axes::text(total_width / 2, 19 + 18 * static_cast<double>(i), "middle", 14, title_lines[i]);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto in_row = static_cast<std::size_t>(columns);
    const Axes axes(panels[i], static_cast<double>(i % in_row) * width, head + static_cast<double>(i / in_row) * height,
                    width, height);
    if (axes.empty()) continue;
    svg += axes.drawn();
    for (const Curve& curve : panels[i].curves) svg += axes.drawn(curve, legend.pen(curve.name));
  }
  return svg + legend.drawn(head + rows * height, total_width) + "</svg>\n";
}

}  // namespace horopter
