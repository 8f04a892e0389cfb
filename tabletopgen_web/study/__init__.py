"""User studies (Secs. 4.2 and 8.2): a page on which people rate scenes, and their answers.

``command`` has the commands, ``collection`` finds the methods' results, ``page`` makes the HTML
file and its key, ``page_data`` fills the built page and reads it back, ``answers`` reads the
raters' answers, ``statistics`` and ``agreement`` evaluate them.
"""
