// SPDX-License-Identifier: Apache-2.0
#include "horopter/draw/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "horopter/base/xml.hpp"

namespace horopter {
namespace {

constexpr std::array colours{"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd", "#8c564b",
                             "#e377c2", "#17becf", "#7f7f7f", "#bcbd22", "#000000", "#3b3b98"};

/// About `count` round steps between two values.
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

}  // namespace

std::string plot_svg(const std::string& title, const std::vector<Panel>& panels, int columns) {
  constexpr double width = 300;
  constexpr double height = 220;
  constexpr double left = 52;
  constexpr double right = 10;
  constexpr double top = 24;
  constexpr double bottom = 36;
  constexpr double head = 30;
  columns = std::max(1, std::min<int>(columns, static_cast<int>(panels.size())));
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;

  std::vector<std::string> names;
  for (const Panel& panel : panels)
    for (const Curve& curve : panel.curves)
      if (std::find(names.begin(), names.end(), curve.name) == names.end()) names.push_back(curve.name);
  // Colours, and dashes once these are used up.
  const auto pen = [&](const std::string& name) {
    const auto index = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    return fmt::format("fill=\"none\" stroke=\"{}\"{}", colours[index % colours.size()],
                       index < colours.size() ? "" : " stroke-dasharray=\"5 3\"");
  };
  std::size_t longest = 1;
  for (const std::string& name : names) longest = std::max(longest, name.size());
  const double entry = 30 + 6.5 * static_cast<double>(longest);
  const int entries = std::max(1, static_cast<int>(columns * width / entry));
  const int legend_rows = (static_cast<int>(names.size()) + entries - 1) / entries;
  const double total_width = columns * width;
  const double total_height = head + rows * height + 16 * legend_rows + 10;

  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"11\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<text x=\"{2}\" y=\"19\" font-size=\"14\" "
      "text-anchor=\"middle\">{3}</text>\n",
      total_width, total_height, total_width / 2, xml_text(title));

  for (std::size_t index = 0; index < panels.size(); ++index) {
    const Panel& panel = panels[index];
    const double ox = static_cast<double>(index % static_cast<std::size_t>(columns)) * width;
    const double oy = head + static_cast<double>(index / static_cast<std::size_t>(columns)) * height;
    double x_low = 1e300;
    double x_high = -1e300;
    double y_low = 1e300;
    double y_high = -1e300;
    const auto y_of = [&](double value) { return panel.log_y ? std::log10(std::max(value, 1e-6)) : value; };
    for (const Curve& curve : panel.curves)
      for (const auto& [x, y] : curve.points) {
        if (!std::isfinite(y)) continue;
        x_low = std::min(x_low, x);
        x_high = std::max(x_high, x);
        y_low = std::min(y_low, y_of(y));
        y_high = std::max(y_high, y_of(y));
      }
    if (x_low > x_high) continue;
    if (x_high - x_low < 1e-12) x_high = x_low + 1;
    if (y_high - y_low < 1e-9) {
      y_low -= 0.5e-3;
      y_high += 0.5e-3;
    }
    const double margin = 0.05 * (y_high - y_low);
    y_low -= margin;
    y_high += margin;
    const double w = width - left - right;
    const double h = height - top - bottom;
    const auto px = [&](double x) { return ox + left + (x - x_low) / (x_high - x_low) * w; };
    const auto py = [&](double y) { return oy + top + (y_high - y) / (y_high - y_low) * h; };

    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-weight=\"bold\">{}</text>\n",
                       ox + left + w / 2, oy + 15, xml_text(panel.title));
    for (const double x : ticks(x_low, x_high, 5))
      svg += fmt::format(
          "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3:.1f}\" "
          "text-anchor=\"middle\" font-size=\"9\">{4:g}</text>\n",
          px(x), oy + top, oy + top + h, oy + top + h + 11, x);
    const auto y_tick = [&](double at, const std::string& label) {
      svg += fmt::format(
          "<path d=\"M{0:.1f} {1:.1f}H{2:.1f}\" stroke=\"#ddd\"/><text x=\"{3:.1f}\" y=\"{4:.1f}\" "
          "text-anchor=\"end\" font-size=\"9\">{5}</text>\n",
          ox + left, py(at), ox + left + w, ox + left - 4, py(at) + 3, label);
    };
    if (panel.log_y) {
      // 1, 2, 5 within a decade where there are few of them.
      for (int power = static_cast<int>(std::floor(y_low)); power <= y_high; ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
          const double at = power + std::log10(digit);
          if (at < y_low || at > y_high || (digit > 1 && y_high - y_low > 2)) continue;
          y_tick(at, fmt::format("{:g}", digit * std::pow(10.0, power)));
        }
    } else {
      for (const double y : ticks(y_low, y_high, 5)) y_tick(y, fmt::format("{:g}", y));
    }
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"black\"/>\n",
                       ox + left, oy + top, w, h);
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"10\">{}</text>\n", ox + left + w / 2,
                       oy + height - 10, xml_text(panel.x_label));
    svg += fmt::format(
        "<text transform=\"translate({} {}) rotate(-90)\" text-anchor=\"middle\" font-size=\"10\">{}</text>\n", ox + 12,
        oy + top + h / 2, xml_text(panel.y_label));
    for (const Curve& curve : panel.curves) {
      std::string path;
      bool pen_down = false;
      for (const auto& [x, y] : curve.points) {
        if (!std::isfinite(y)) {
          pen_down = false;
          continue;
        }
        path += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", px(x), py(y_of(y)));
        pen_down = true;
      }
      svg += fmt::format("<path d=\"{}\" {} stroke-width=\"1.4\"><title>{}</title></path>\n", path, pen(curve.name),
                         xml_text(curve.name));
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double x = 12 + static_cast<double>(i % static_cast<std::size_t>(entries)) * entry;
    const double y = head + rows * height + 12 + 16 * static_cast<double>(i / static_cast<std::size_t>(entries));
    svg +=
        fmt::format("<path d=\"M{:.1f} {:.1f}h18\" {} stroke-width=\"2\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                    x, y - 4, pen(names[i]), x + 23, y, xml_text(names[i]));
  }
  return svg + "</svg>\n";
}

}  // namespace horopter
