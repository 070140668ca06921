# Links to headings: those within a page become text, those to other pages lead to the page.
s/\[([^]]*)\]\(#[^)]*\)/\1/g
s/(README\.md)#[^)]*\)/\1)/g
