#include "belief/offline/plan_page.hpp"

#include <algorithm>
#include <cstdio>

#include "belief/offline/plan_tree.hpp"
#include "search/text/markup.hpp"

namespace praxis::belief {
namespace {

constexpr const char* kStyle =
    "body{font:14px/1.4 system-ui,sans-serif;margin:1.5em;color:#1d2733;background:#fff}"
    "h1{font-size:1.3em;margin:0 0 .2em}p{margin:.2em 0 1em;color:#51606f}"
    ".drawing{overflow:auto;max-height:80vh;border:1px solid #cfd8e0;border-radius:6px}"
    "svg text{font:11px ui-monospace,monospace;fill:#1d2733}"
    "svg .box{fill:#eef4fa;stroke:#6b8db0}svg :target .box{stroke-width:3;stroke:#d17b0f}"
    "svg .goal{fill:#d8f0dc;stroke:#4d9a5b}svg .link{fill:#fff;stroke:#9aa7b3;stroke-dasharray:3 2}"
    "svg path{fill:none;stroke:#8896a3}svg "
    ".answer{fill:#8a4b08;paint-order:stroke;stroke:#fff;stroke-width:4px}svg .number{fill:#8896a3}"
    "code{font:12px ui-monospace,monospace;white-space:pre}"
    "details{margin-left:1.2em}summary{cursor:pointer}ol{margin:.2em 0 .6em}code.answer{color:#8a4b08}"
    "@media(prefers-color-scheme:dark){body{background:#14191f;color:#d9e1e8}p{color:#93a1ad}"
    "svg text{fill:#d9e1e8}svg .box{fill:#1e2b38}svg .goal{fill:#1c3a24}svg .link{fill:#14191f}"
    "svg "
    ".answer{fill:#e0a35a;stroke:#14191f}code.answer{color:#e0a35a}a{color:#7db4e8}.drawing{border-color:#"
    "33404d}}";

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string block_name(std::uint32_t block) {
    return std::to_string(block + 1);
}

std::string text_at(double x, double y, const std::string& text, const char* more = "") {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\"" + more + ">" + escape_markup(text) +
           "</text>";
}

class Page {
  public:
    explicit Page(const std::vector<PlanBlock>& blocks) : blocks_(blocks) {}

    std::string drawing() {
        const PlanTree tree = lay_out(blocks_);
        text_ = "<div class=\"drawing\"><svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                number(tree.width) + "\" height=\"" + number(tree.height) + "\">\n";
        for (std::size_t i = 1; i < tree.boxes.size(); ++i) draw_edge(tree, tree.boxes[i]);
        for (const PlanBox& box : tree.boxes) draw_box(box);
        return text_ + "</svg></div>\n";
    }

    std::string outline() {
        text_.clear();
        for (std::uint32_t block = 0; block < blocks_.size(); ++block) outline_block(block);
        return text_;
    }

  private:
    void draw_edge(const PlanTree& tree, const PlanBox& box) {
        const PlanBox& above = tree.boxes[box.parent];
        const auto& answers = blocks_[above.block].choices[box.choice].answers;
        const double middle = box.x + box.width / 2;
        const double from = above.y + above.height;
        const double bend = (from + box.y - kPlanLine * static_cast<double>(answers.size())) / 2;
        const double start = above.x + above.width / 2;
        text_ += "<path d=\"M" + number(start) + " " + number(from) + "V" + number(bend) + "H" +
                 number(middle) + "V" + number(box.y) + "\"/>";
        double y = box.y - 6 - kPlanLine * static_cast<double>(answers.empty() ? 0 : answers.size() - 1);
        for (const std::string& answer : answers) {
            text_ += text_at(middle, y, answer, " class=\"answer\" text-anchor=\"middle\"");
            y += kPlanLine;
        }
        text_ += "\n";
    }

    void draw_box(const PlanBox& box) {
        const bool block = box.kind == PlanBox::Kind::block;
        const bool link = box.kind == PlanBox::Kind::link;
        if (link) text_ += "<a href=\"#b" + block_name(box.block) + "\">";
        text_ += block ? "<g id=\"b" + block_name(box.block) + "\">" : "<g>";
        text_ += "<rect class=\"" +
                 std::string(block  ? "box"
                             : link ? "link"
                                    : "goal") +
                 "\" x=\"" + number(box.x) + "\" y=\"" + number(box.y) + "\" width=\"" + number(box.width) +
                 "\" height=\"" + number(box.height) + "\" rx=\"4\"/>";
        double y = box.y + kPlanLine;
        if (block) {
            text_ += text_at(box.x + box.width - 6, y, block_name(box.block),
                             " class=\"number\" text-anchor=\"end\"");
            for (const std::string& action : blocks_[box.block].actions) {
                text_ += text_at(box.x + 8, y, action);
                y += kPlanLine;
            }
            if (blocks_[box.block].actions.empty()) text_ += text_at(box.x + 8, y, "start");
        } else {
            text_ += text_at(box.x + box.width / 2, y, link ? "as in " + block_name(box.block) : "goal",
                             " text-anchor=\"middle\"");
        }
        text_ += link ? "</g></a>\n" : "</g>\n";
    }

    void outline_block(std::uint32_t block) {
        const PlanBlock& content = blocks_[block];
        text_ +=
            "<details open id=\"o" + block_name(block) + "\"><summary>" + block_name(block) + "</summary>";
        if (!content.actions.empty()) {
            text_ += "<ol>";
            for (const std::string& action : content.actions)
                text_ += "<li><code>" + escape_markup(action) + "</code></li>";
            text_ += "</ol>";
        }
        text_ += "<ul>";
        for (const PlanBlock::Choice& choice : content.choices) {
            text_ += "<li>";
            if (!choice.answers.empty()) {
                text_ += "if <code class=\"answer\">";
                for (std::size_t i = 0; i < choice.answers.size(); ++i)
                    text_ += (i == 0 ? "" : ", ") + escape_markup(choice.answers[i]);
                text_ += "</code>: ";
            }
            if (choice.target == PlanBlock::kGoal) {
                text_ += "done";
            } else {
                text_ += "go to <a href=\"#o" + block_name(choice.target) + "\">" +
                         block_name(choice.target) + "</a>";
            }
            text_ += "</li>";
        }
        text_ += "</ul></details>\n";
    }

    const std::vector<PlanBlock>& blocks_;
    std::string text_;
};

}  // namespace

std::string plan_to_html(const BeliefTask& task, const ConditionalPlan& plan, const std::string& title,
                         const std::string& summary) {
    const std::vector<PlanBlock> blocks = plan_blocks(task, plan);
    Page page(blocks);
    std::string text = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>" +
                       escape_markup(title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" +
                       escape_markup(title) + "</h1>\n<p>" + escape_markup(summary) + "</p>\n";
    if (blocks.empty()) {
        text += "<p>Nothing to do.</p>\n";
    } else if (blocks.size() <= kMostDrawn) {
        text += page.drawing();
    } else {
        text += "<p>Too large to draw.</p>\n";
    }
    return text + page.outline() + "</body></html>\n";
}

}  // namespace praxis::belief
