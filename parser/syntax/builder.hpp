// What the grammar's actions call to grow a tree: plain appends to its arrays.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "parser/syntax/tree.hpp"

namespace praxis::syntax {

/// A syntax error that the grammar's expectations cannot express.
struct SyntaxError {
    std::uint32_t offset;
    std::uint32_t length;
    std::string message;
};

class Builder {
  public:
    /// Lists may be nested so deep; the parser and everybody after it recurses over them.
    static constexpr std::size_t kMaxDepth = 400;

    Builder(Tree& tree, SymbolTable& symbols) : tree_(tree), symbols_(symbols) {}

    Tree& tree() { return tree_; }
    SymbolTable& symbols() { return symbols_; }
    const char* begin() const { return tree_.text.data(); }
    std::uint32_t offset_of(const char* at) const { return static_cast<std::uint32_t>(at - begin()); }

    void open(std::uint32_t offset) {
        if (open_.size() == kMaxDepth) throw SyntaxError{offset, 1, too_deep()};
        Node& node = tree_.nodes.emplace_back();
        node.offset = offset;
        node.arguments = {names(), names()};
        open_.push_back(node_count() - 1);
    }
    void close(std::uint32_t offset) {
        Node& node = top();
        node.length = offset + 1 - node.offset;
        node.end = node_count();
        if (node.kind == NodeKind::atom || node.kind == NodeKind::nested) node.arguments.end = names();
        last_ = open_.back();
        open_.pop_back();
    }
    void set_head(NodeKind kind, const Name& head) {
        top().kind = kind;
        top().head = head;
    }
    void add_argument(const Name& name) { tree_.names.push_back(name); }
    void mark_nested() { top().kind = NodeKind::nested; }
    void add_word(const Name& word) {
        Node& node = tree_.nodes.emplace_back();
        node.kind = NodeKind::word;
        node.head = word;
        node.offset = word.offset;
        node.length = word.length;
        node.end = node_count();
        last_ = node.end - 1;
    }
    void bind(Range variables) { top().variables = variables; }

    /// The node that was completed last.
    NodeIndex last() const { return last_; }

    void begin_list() { list_begin_ = typed_begin_ = typed_names(); }
    void add_item(const Name& name) { tree_.typed_names.push_back({name, {}}); }
    void begin_types() { types_begin_ = names(); }
    void add_type(const Name& name) { tree_.names.push_back(name); }
    /// The types since begin_types.
    Range types() const { return {types_begin_, names()}; }
    /// Gives them to the items that have none yet.
    void apply_types() {
        for (; typed_begin_ < typed_names(); ++typed_begin_) tree_.typed_names[typed_begin_].types = types();
    }
    Range list() const { return {list_begin_, typed_names()}; }

    void enter(std::uint32_t offset) {
        if (++plain_depth_ > kMaxDepth) throw SyntaxError{offset, 1, too_deep()};
    }
    void leave() { --plain_depth_; }

    /// Forgets what was begun and not finished, after a syntax error.
    void abandon() {
        open_.clear();
        plain_depth_ = 0;
        tree_.broken = true;
    }

  private:
    Node& top() { return tree_.nodes[open_.back()]; }
    std::uint32_t node_count() const { return static_cast<std::uint32_t>(tree_.nodes.size()); }
    std::uint32_t names() const { return static_cast<std::uint32_t>(tree_.names.size()); }
    std::uint32_t typed_names() const { return static_cast<std::uint32_t>(tree_.typed_names.size()); }
    static std::string too_deep() { return "lists nested more than " + std::to_string(kMaxDepth) + " deep"; }

    Tree& tree_;
    SymbolTable& symbols_;
    std::vector<NodeIndex> open_;
    NodeIndex last_ = kNoNode;
    std::uint32_t list_begin_ = 0;
    std::uint32_t typed_begin_ = 0;
    std::uint32_t types_begin_ = 0;
    std::size_t plain_depth_ = 0;
};

}  // namespace praxis::syntax
