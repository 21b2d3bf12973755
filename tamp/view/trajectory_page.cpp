#include "tamp/view/trajectory_page.hpp"

#include <ostream>

#include "parser/diagnostic.hpp"
#include "search/text/markup.hpp"
#include "tamp/report/document_json.hpp"
#include "tamp/view/page_template.hpp"

namespace praxis::tamp {

namespace {

void write_pieces(std::span<const std::string_view> pieces, std::ostream& out) {
    for (const std::string_view piece : pieces) out << piece;
}

/// JSON has "<" only inside of texts, where "\u003c" means the same and cannot end a script element.
std::string without_markup(const std::string& json) {
    std::string result;
    result.reserve(json.size());
    for (const char c : json) {
        if (c == '<') {
            result += "\\u003c";
        } else {
            result += c;
        }
    }
    return result;
}

}  // namespace

bool has_viewer() {
    return page_template() != nullptr;
}

void write_view(const TrajectoryDocument& document, std::ostream& out) {
    const PageTemplate* page = page_template();
    if (!page) {
        const Diagnostic diagnostic{Severity::unsupported,
                                    {},
                                    false,
                                    "this build of Praxis has no viewer: install npm and configure with "
                                    "-DPRAXIS_BUILD_VIEWER=ON",
                                    ""};
        throw UnsupportedError(to_string(diagnostic, {}), {diagnostic});
    }
    const std::string json = without_markup(to_json(document));
    write_pieces(page->before_title, out);
    out << escape_markup(document.robot.name + ": trajectory");
    write_pieces(page->before_document, out);
    out << json;
    write_pieces(page->after_document, out);
}

}  // namespace praxis::tamp
